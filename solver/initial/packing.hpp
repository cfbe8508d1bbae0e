#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/base/random.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::initial {

/// `n` points filling a sphere of the given radius at uniform number density, centre of mass at
/// the origin. "glass": disordered but even, from repelling points in a periodic box, so no
/// direction is preferred and no plane slips more easily; "lattice": a randomly turned and
/// shifted face-centred cubic lattice. Throws InputError for another name.
std::vector<Vec3> packed_sphere(const std::string& packing, std::size_t n, double radius,
                                Random& random);

}  // namespace eerie::initial
