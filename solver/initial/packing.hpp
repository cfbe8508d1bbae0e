#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/base/random.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::initial {

/// Fills a sphere of the given radius with `n` points of uniform number density, whose centre of
/// mass is the origin. "glass" is disordered but even: points repel each other in a periodic box,
/// so no direction is preferred and no plane slips more easily. "lattice" is a face-centred cubic
/// lattice, randomly turned and shifted. Throws InputError for another name.
std::vector<Vec3> packed_sphere(const std::string& packing, std::size_t n, double radius,
                                Random& random);

}  // namespace eerie::initial
