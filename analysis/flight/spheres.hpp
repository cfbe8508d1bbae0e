#pragma once

#include <vector>

#include "analysis/flight/rigid_body.hpp"

namespace eerie::flight {

/// The spheres around thousands of bodies, side by side in memory. They show for most pairs that
/// they are far apart, without a look at the bodies themselves.
class Spheres {
 public:
  void take(const std::vector<RigidBody>& bodies);
  void set(std::size_t k, const RigidBody& body);
  void erase(std::size_t k);
  /// The first sphere after index `last` within `contact` (m) of sphere `k`; the number of spheres
  /// where there is none.
  std::size_t next_within(double contact, std::size_t k, std::size_t last) const;

 private:
  std::vector<double> x_, y_, z_, radius_;  ///< m
};

}  // namespace eerie::flight
