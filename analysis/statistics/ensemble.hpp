#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace eerie::statistics {

/// What the runs of one impact with several seeds say about one quantity; all 0 for no run.
struct Ensemble {
  std::size_t runs = 0;
  double mean = 0, deviation = 0;  ///< of the sample, over runs - 1; 0 for one run
  double low = 0, high = 0;
};
Ensemble ensemble(const std::vector<double>& values);

/// Nothing where no run has the number.
std::optional<double> mean_of(const Ensemble& e);
/// Nothing where fewer than two have it.
std::optional<double> deviation_of(const Ensemble& e);

}  // namespace eerie::statistics
