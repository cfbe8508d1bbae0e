#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace eerie {

/// Sentences about settings of a valid scene that docs/notebook/stability.md found to be beyond a
/// method's safe range: the field, its value, what happens there and the mend. Empty for a sound
/// scene.
std::vector<std::string> warnings(const Scene& scene);

}  // namespace eerie
