#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/base/random.hpp"
#include "solver/base/vec3.hpp"

namespace eerie::initial {

/// A packing was told to stop.
struct PackingStopped : std::runtime_error {
  PackingStopped() : std::runtime_error("stopped while particles were packed") {}
};

/// `n` points filling a sphere of the given radius at uniform number density, centre of mass at
/// the origin. "glass": disordered but even, from repelling points in a periodic box, so no
/// direction is preferred and no plane slips more easily; "lattice": a randomly turned and
/// shifted face-centred cubic lattice. Throws InputError for another name, and PackingStopped where
/// `stop`, asked some 150 times for a glass, says so.
std::vector<Vec3> packed_sphere(const std::string& packing, std::size_t n, double radius,
                                Random& random, const std::function<bool()>& stop = {});

}  // namespace eerie::initial
