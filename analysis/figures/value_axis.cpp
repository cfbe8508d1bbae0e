#include "analysis/figures/value_axis.hpp"

#include <algorithm>
#include <cmath>

namespace eerie::figures {

drawing::Script value_axis(double low, double high) {
  const double fifth = std::max((high - low) / 5, 1e-12);
  const double decade = std::pow(10, std::floor(std::log10(fifth)));
  const double step = decade * (fifth >= 7.5 * decade   ? 10
                                : fifth >= 3.5 * decade ? 5
                                : fifth >= 1.5 * decade ? 2
                                                        : 1);
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  return drawing::script("set yrange [{}:{}]\nset ytics {}\nset format y '%.{}f'\n", low, high,
                         step, decimals);
}

}  // namespace eerie::figures
