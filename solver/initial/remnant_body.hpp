#pragma once

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::initial {

/// Whether a body is not made but read from a file (scene.target.remnant).
bool is_remnant(const Scene& scene, particles::Body body);

/// The target as another impact left it, from the file that the scene names. In the file it is
/// about the origin, its longest axis along x and its shortest along z; here it is turned to the
/// axes of target_shape(). It spins as it did. Throws InputError where the file cannot be read, is
/// another one, or holds other particles than the scene says.
particles::State remnant_body(const Scene& scene);
/// Throws what remnant_body() would.
void require_remnant(const Scene& scene);

}  // namespace eerie::initial
