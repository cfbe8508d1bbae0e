#pragma once

#include <cstddef>
#include <vector>

namespace eerie::statistics {

/// What the runs of one impact with several seeds say about one quantity.
struct Ensemble {
  std::size_t runs = 0;
  double mean = 0, deviation = 0;  ///< standard deviation of single runs; 0 for one run
  double low = 0, high = 0;
};
Ensemble ensemble(const std::vector<double>& values);

}  // namespace eerie::statistics
