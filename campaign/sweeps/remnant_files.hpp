#pragma once

#include <span>

#include "solver/scene/scene.hpp"

namespace eerie::sweeps {

/// Reads the file of each remnant that the scenes name, once, so that one that is missing or does
/// not fit is refused before anything is stored. Throws InputError, as the solver would.
void require_remnants(std::span<const Scene> scenes);

}  // namespace eerie::sweeps
