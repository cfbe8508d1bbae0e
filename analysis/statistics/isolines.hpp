#pragma once

#include <array>
#include <vector>

namespace eerie::statistics {

/// A curve in data coordinates, point after point; a closed one ends where it begins.
using Isoline = std::vector<std::array<double, 2>>;

/// The curves on which `values` (at x[i], y[j]: values[j * x.size() + i]) equal `level`, by
/// interpolation along the edges of each cell (marching squares). In a saddle the mean of the four
/// corners says which of them belong together. `x` and `y` ascend. Throws std::invalid_argument for
/// another number of values.
std::vector<Isoline> isolines(const std::vector<double>& x, const std::vector<double>& y,
                              const std::vector<double>& values, double level);

}  // namespace eerie::statistics
