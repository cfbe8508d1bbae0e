#include "analysis/statistics/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace eerie::statistics {

Ensemble ensemble(const std::vector<double>& values) {
  Ensemble e{values.size(), 0, 0, 0, 0};
  if (values.empty()) return e;
  const auto n = static_cast<double>(values.size());
  e.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  for (const double value : values) e.deviation += (value - e.mean) * (value - e.mean);
  e.deviation = values.size() > 1 ? std::sqrt(e.deviation / (n - 1)) : 0;
  const auto [low, high] = std::ranges::minmax(values);
  e.low = low, e.high = high;
  return e;
}

std::optional<double> mean_of(const Ensemble& e) {
  return e.runs > 0 ? std::optional(e.mean) : std::nullopt;
}

std::optional<double> deviation_of(const Ensemble& e) {
  return e.runs > 1 ? std::optional(e.deviation) : std::nullopt;
}

double quantile(const std::vector<double>& ascending, double part) {
  return ascending[static_cast<std::size_t>(
      std::lround(part * static_cast<double>(ascending.size() - 1)))];
}

}  // namespace eerie::statistics
