#include "analysis/flight/spheres.hpp"

#include <algorithm>
#include <cstddef>

namespace eerie::flight {

namespace {

/// So many are compared before it is asked whether any was near.
constexpr std::size_t chunk = 64;
/// No pair is lost to rounding.
constexpr double generous = 1 + 1e-9;

}  // namespace

void Spheres::take(const std::vector<RigidBody>& bodies) {
  for (std::vector<double>* column : {&x_, &y_, &z_, &radius_}) column->resize(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) set(k, bodies[k]);
}

void Spheres::set(std::size_t k, const RigidBody& body) {
  x_[k] = body.x.x, y_[k] = body.x.y, z_[k] = body.x.z, radius_[k] = body.radius;
}

void Spheres::erase(std::size_t k) {
  for (std::vector<double>* column : {&x_, &y_, &z_, &radius_})
    column->erase(column->begin() + static_cast<std::ptrdiff_t>(k));
}

std::size_t Spheres::next_within(double contact, std::size_t k, std::size_t last) const {
  const double x = x_[k], y = y_[k], z = z_[k], own = (radius_[k] + contact) * generous;
  const auto is_near = [&](std::size_t b) {
    const double dx = x_[b] - x, dy = y_[b] - y, dz = z_[b] - z, reach = radius_[b] + own;
    return dx * dx + dy * dy + dz * dz <= reach * reach;
  };
  for (std::size_t first = last + 1; first < x_.size(); first += chunk) {
    const std::size_t end = std::min(first + chunk, x_.size());
    int near = 0;
    for (std::size_t b = first; b < end; ++b) near |= is_near(b);
    if (near == 0) continue;
    for (std::size_t b = first; b < end; ++b)
      if (is_near(b)) return b;
  }
  return x_.size();
}

}  // namespace eerie::flight
