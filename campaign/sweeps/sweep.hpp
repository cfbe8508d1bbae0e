#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "campaign/sweeps/axis.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::sweeps {

/// Impacts one by one: each row has a value for each of the fields.
struct SweepPoints {
  std::vector<std::string> paths;  ///< dotted, sorted
  std::vector<std::vector<double>> rows;
};

/// Impacts as read from a sweep file (sweep.schema.json) and --set overrides: every point with
/// every combination of the axes.
struct Sweep {
  std::string name;
  nlohmann::json scene;  ///< fields shared by every point, as given
  std::vector<Axis> axes;
  SweepPoints points;  ///< none: the axes alone
  std::string where;   ///< file name, for messages
};

/// Reads and checks everything but the combinations of axis values. Throws InputError naming
/// path, value, allowed range and mend.
Sweep parse_sweep(const nlohmann::json& document, const std::vector<std::string>& overrides,
                  const std::string& where);
Sweep load_sweep(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

std::size_t point_count(const Sweep& sweep);

/// One scene per job; the points in their order, then the axes, of which the last varies fastest.
/// Throws InputError for a combination that makes no scene.
std::vector<Scene> expand(const Sweep& sweep);

/// The sweep as one line of canonical JSON: what makes it the same sweep.
std::string document(const Sweep& sweep);

}  // namespace eerie::sweeps
