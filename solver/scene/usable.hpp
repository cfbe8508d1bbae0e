#pragma once

#include <string>

#include "solver/scene/scene.hpp"

namespace eerie {

/// Throws InputError where fields that are each within their range do not fit together. `where`
/// names the scene.
void require_usable(const Scene& scene, const std::string& where);

}  // namespace eerie
