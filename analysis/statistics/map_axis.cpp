#include "analysis/statistics/map_axis.hpp"

#include <algorithm>
#include <cmath>

namespace eerie::statistics {

std::size_t MapAxis::index(double value) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(at, value) - at.begin());
}

MapAxis map_axis(std::vector<double> values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  MapAxis axis{std::move(values), {}};
  const std::vector<double>& at = axis.at;
  const std::size_t last = at.size() - 1;
  const double first_half = last > 0 ? (at[1] - at[0]) / 2 : 0.5;
  const double last_half = last > 0 ? (at[last] - at[last - 1]) / 2 : 0.5;
  axis.edges.push_back(at[0] - first_half);
  for (std::size_t k = 0; k < last; ++k) axis.edges.push_back((at[k] + at[k + 1]) / 2);
  axis.edges.push_back(at[last] + last_half);
  return axis;
}

std::vector<double> round_ticks(double low, double high, int most) {
  const double power = std::pow(10, std::floor(std::log10((high - low) / most)));
  double step = power;
  for (const double factor : {2.0, 5.0, 10.0, 20.0})
    if (std::floor(high / step) - std::ceil(low / step) + 1 > most) step = factor * power;
  std::vector<double> ticks;
  for (double k = std::ceil(low / step); k * step <= high; ++k) ticks.push_back(k * step);
  return ticks;
}

}  // namespace eerie::statistics
