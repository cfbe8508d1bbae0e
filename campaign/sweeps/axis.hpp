#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "campaign/sweeps/scene_field.hpp"

namespace eerie::sweeps {

/// The most jobs of a sweep, and so the most values of an axis.
inline constexpr std::size_t max_sweep_jobs = 200'000;

/// One axis of a grid: a field of the scene and its values, which are numbers in their canonical
/// form, or words, or true and false.
struct Axis {
  std::string path;  ///< dotted
  std::vector<nlohmann::json> values;
};

/// Reads an axis: a list, or for numbers {"from", "to", "step"} with both ends included. It checks
/// each value against the scene's schema. Throws InputError; `where` names file and axis.
Axis parse_axis(const std::string& name, const nlohmann::json& spec, const std::string& where);

/// The values from, from + step, ... to. Each is the double closest to its decimal, so 0.1 + 2 *
/// 0.1 is 0.3. Throws InputError where step <= 0, where to < from, or where `to` is not among the
/// values.
std::vector<double> inclusive_range(double from, double to, double step, const std::string& where);

}  // namespace eerie::sweeps
