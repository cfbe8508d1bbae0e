#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace eerie::sweeps {

/// The values of --set and --fidelity.
struct SceneChanges {
  std::vector<std::string> overrides = {};  ///< PATH=VALUE
  std::string fidelity = {};                ///< empty: as the file says

  /// The overrides of the fidelity, then those of --set. Throws InputError for an unknown fidelity.
  std::vector<std::string> all() const;

  /// Says which fields of a scene, as its file gives it, the fidelity replaces by another value.
  /// Fields of --set are left out, since these decide. `where` names the file.
  std::vector<std::string> replaced(const nlohmann::json& scene, const std::string& where) const;
};

}  // namespace eerie::sweeps
