#pragma once

#include <span>

#include "solver/scene/scene.hpp"

namespace eerie::sweeps {

/// Refuses impacts that could not begin, before anything is stored: a remnant whose file is missing
/// or does not fit, and bodies that the tide of a primary never lets come from as far apart as they
/// start. Each remnant is read once. Throws InputError, as the solver would.
void require_beginnings(std::span<const Scene> scenes);

}  // namespace eerie::sweeps
