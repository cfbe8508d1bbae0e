#pragma once

#include <vector>

#include "solver/scene/scene.hpp"
#include "solver/tree/images.hpp"

namespace eerie::step {

/// The walls of a scene, as mirrors.
std::vector<tree::Mirror> mirrors(const Scene::Environment& environment);

/// Throws InputError where two walls of an axis are closer than `search_radius` (m), since a
/// particle would then have images of images as neighbours.
void require_walls_apart(const Scene::Environment& environment, double search_radius);

}  // namespace eerie::step
