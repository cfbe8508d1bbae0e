#include "analysis/statistics/ensemble.hpp"

#include <algorithm>
#include <cmath>

namespace eerie::statistics {

Ensemble ensemble(const std::vector<double>& values) {
  Ensemble e{values.size(), 0, 0, 0, 0};
  if (values.empty()) return e;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) e.mean += value / n;
  for (const double value : values) e.deviation += (value - e.mean) * (value - e.mean);
  e.deviation = values.size() > 1 ? std::sqrt(e.deviation / (n - 1)) : 0;
  const auto [low, high] = std::ranges::minmax(values);
  e.low = low, e.high = high;
  return e;
}

}  // namespace eerie::statistics
