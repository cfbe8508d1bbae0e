#pragma once

#include <string>
#include <vector>

namespace eerie::statistics {

/// The positions of the cells of a map along one axis: at[k] lies between edges[k] and edges[k+1].
struct MapAxis {
  std::vector<double> at;     ///< ascending, all different
  std::vector<double> edges;  ///< half-way between neighbours; outermost cells are symmetric

  /// The index of a value, which must be one of `at`.
  std::size_t index(double value) const;
};

/// Makes the axis through these values: at least one, in any order, with repetitions. A single
/// value gets a cell of width 1.
MapAxis map_axis(std::vector<double> values);

/// Returns at most `most` round numbers within [low, high]: multiples of 1, 2 or 5 times a power of
/// ten.
std::vector<double> round_ticks(double low, double high, int most);

}  // namespace eerie::statistics
