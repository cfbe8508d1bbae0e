#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace eerie {

/// Sentences about settings of a valid scene that lie beyond the safe range of a method
/// (docs/notebook/stability.md). Each names the field, its value, what happens there and the mend.
/// A sound scene gives none.
std::vector<std::string> warnings(const Scene& scene);

}  // namespace eerie
