#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "solver/base/error.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::test {

/// The reference impact with few particles, and `changes` on top (a JSON merge patch).
inline Scene small_scene(const nlohmann::json& changes = nlohmann::json::object()) {
  nlohmann::json scene = {{"numerics", {{"particles_per_target", 300}}}};
  scene.merge_patch(changes);
  return parse_scene(scene);
}

/// What such a scene is refused with, or "".
inline std::string refusal(const nlohmann::json& changes) {
  try {
    small_scene(changes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Basalt with its real moduli; the default scene has them reduced by a million.
inline nlohmann::json stiff_basalt() {
  return {{"material",
           {{"shear_modulus_Pa", 2.27e10}, {"tillotson", {{"A_Pa", 2.67e10}, {"B_Pa", 2.67e10}}}}}};
}

}  // namespace eerie::test
