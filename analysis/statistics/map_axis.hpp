#pragma once

#include <string>
#include <vector>

namespace eerie::statistics {

/// The places of a map's cells along one axis: at[k] lies between edges[k] and edges[k+1].
struct MapAxis {
  std::vector<double> at;     ///< ascending, all different
  std::vector<double> edges;  ///< half-way between neighbours; outermost cells are symmetric

  /// Which place a value is; it must be one.
  std::size_t index(double value) const;
};

/// Axis through these values (any order, repeated values allowed, at least one). A single value
/// gets a cell of width 1.
MapAxis map_axis(std::vector<double> values);

/// Round numbers within [low, high], at most `most` of them: multiples of 1, 2 or 5 times a power
/// of ten.
std::vector<double> round_ticks(double low, double high, int most);

}  // namespace eerie::statistics
