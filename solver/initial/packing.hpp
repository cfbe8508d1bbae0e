#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/base/random.hpp"
#include "solver/base/vec3.hpp"
#include "solver/scene/body_shape.hpp"

namespace eerie::initial {

/// A packing was stopped on request.
struct PackingStopped : std::runtime_error {
  PackingStopped() : std::runtime_error("stopped while particles were packed") {}
};

/// Fills a sphere of the given radius with `n` points of uniform number density, whose centre of
/// mass is the origin. "glass" is disordered but even: points repel each other in a periodic box,
/// so no direction is preferred and no plane slips more easily. "lattice" is a face-centred cubic
/// lattice, randomly turned and shifted. Throws InputError for another name. Calls `stop` some 150
/// times for a glass, and throws PackingStopped where it returns true.
std::vector<Vec3> packed_sphere(const std::string& packing, std::size_t n, double radius,
                                Random& random, const std::function<bool()>& stop = {});

/// The same for a body of another shape. `radius` is that of the sphere of its volume.
std::vector<Vec3> packed_body(const BodyShape& shape, const std::string& packing, std::size_t n,
                              double radius, Random& random,
                              const std::function<bool()>& stop = {});

}  // namespace eerie::initial
