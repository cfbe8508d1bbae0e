#pragma once

#include <vector>

#include "analysis/flight/rigid_body.hpp"

namespace eerie::flight {

/// The spheres around bodies, side by side: most pairs are found to be far apart without a look at
/// the bodies themselves, of which there may be thousands.
class Spheres {
 public:
  void take(const std::vector<RigidBody>& bodies);
  void set(std::size_t k, const RigidBody& body);
  void erase(std::size_t k);
  /// The first after `last` that comes within `contact` (m) of number `k`; their number if none.
  std::size_t next_within(double contact, std::size_t k, std::size_t last) const;

 private:
  std::vector<double> x_, y_, z_, radius_;  ///< m
};

}  // namespace eerie::flight
