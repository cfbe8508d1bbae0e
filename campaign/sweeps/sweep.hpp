#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "campaign/sweeps/axis.hpp"
#include "campaign/sweeps/scene_changes.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::sweeps {

/// A list of impacts. Each row has a value for each of the fields.
struct SweepPoints {
  std::vector<std::string> paths;  ///< dotted, sorted
  std::vector<std::vector<nlohmann::json>> rows;
};

/// The impacts of a sweep file (sweep.schema.json) with --set overrides. It combines every point
/// with every combination of the axes.
struct Sweep {
  std::string name;
  nlohmann::json scene;  ///< the fields that all points share, as given
  std::vector<Axis> axes;
  SweepPoints points;  ///< empty: only the axes vary
  std::string where;   ///< file name, for messages
};

/// Reads and checks everything except the combinations of axis values. Throws InputError, which
/// names path, value, allowed range and mend.
Sweep parse_sweep(const nlohmann::json& document, const std::vector<std::string>& overrides,
                  const std::string& where);
Sweep load_sweep(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The scene of one impact, and what SceneChanges::replaced() says of its file.
struct GivenScene {
  Scene scene;
  std::vector<std::string> replaced;
};
/// Reads the scene of one impact. Throws InputError.
GivenScene load_scene(const std::filesystem::path& path, const SceneChanges& changes);

std::size_t point_count(const Sweep& sweep);

/// Whether a field that points or axes vary decides whether over_default_fidelity() applies. If so,
/// that is asked for each impact.
bool varies_default_fidelity(const Sweep& sweep);

/// Makes one scene per job. Points vary slowest, in their order, and the last axis varies fastest.
/// Throws InputError for a combination that makes no scene.
std::vector<Scene> expand(const Sweep& sweep);

/// The sweep as one line of canonical JSON. Equal lines mean equal sweeps.
std::string document(const Sweep& sweep);

}  // namespace eerie::sweeps
