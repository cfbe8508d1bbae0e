#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "campaign/sweeps/scene_field.hpp"

namespace eerie::sweeps {

/// No sweep has more jobs, and so no axis more values.
inline constexpr std::size_t max_sweep_jobs = 1'000'000;

/// One axis of a grid: a numeric field of the scene and the values it takes.
struct Axis {
  std::string path;  ///< dotted
  std::vector<double> values;
};

/// Reads an axis: a list of numbers, or {"from", "to", "step"} with both ends in. Each value
/// is checked against the scene's schema. Throws InputError; `where` names file and axis.
Axis parse_axis(const std::string& name, const nlohmann::json& spec, const std::string& where);

/// from, from + step, ... to, each the double closest to its decimal: 0.1 + 2 * 0.1 is 0.3.
/// Throws InputError where step <= 0, to < from, or `to` is not among them.
std::vector<double> inclusive_range(double from, double to, double step, const std::string& where);

}  // namespace eerie::sweeps
