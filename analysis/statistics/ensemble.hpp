#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace eerie::statistics {

/// The statistics of one quantity over the runs of one impact with several seeds. All numbers are 0
/// without runs.
struct Ensemble {
  std::size_t runs = 0;
  double mean = 0, deviation = 0;  ///< sample deviation (divided by runs - 1); 0 for one run
  double low = 0, high = 0;
};
Ensemble ensemble(const std::vector<double>& values);

/// The mean; nothing where no run has the number.
std::optional<double> mean_of(const Ensemble& e);
/// The deviation; nothing where fewer than two runs have the number.
std::optional<double> deviation_of(const Ensemble& e);

/// The value below which `part` of some values lie, which ascend and are at least one; the nearest
/// of them.
double quantile(const std::vector<double>& ascending, double part);

}  // namespace eerie::statistics
