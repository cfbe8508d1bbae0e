#pragma once

#include <cstdint>
#include <vector>

#include "analysis/flight/rigid_body.hpp"
#include "solver/tree/gravity.hpp"
#include "solver/tree/kd_tree.hpp"

namespace eerie::flight {

/// Force on a body, N, and torque about its centre of mass, N m.
struct Pull {
  Vec3 force, torque;
};

/// Gravity of the particles of rigid bodies on those of all others. What a heavy body does to
/// itself is left out: it should be nothing, but the tree's forces within a body do not sum to
/// zero, and over a long flight what is left would carry it away. Light bodies pull in common.
class MutualGravity {
 public:
  /// `heavy`: from this mass on a body counts as heavy, kg.
  MutualGravity(const tree::Gravity::Parameters& parameters, double heavy)
      : parameters_(parameters), heavy_(heavy) {}

  /// To be called first, and whenever bodies have changed by more than motion; puts the members of
  /// heavy ones into kd order.
  void take(std::vector<RigidBody>& bodies, const std::vector<std::uint32_t>& id);

  /// On every body, by the places that they have now.
  std::vector<Pull> pulls(const std::vector<RigidBody>& bodies);

 private:
  /// A particle as a member of a body.
  struct Member {
    std::size_t body, k;
  };
  /// Particles that pull in common, in kd order.
  struct Crowd {
    std::vector<Member> members;
    std::vector<Vec3> x, g;
    tree::KdTree tree;
    tree::Gravity gravity;
    bool is_one_body;
  };
  Crowd crowd(std::vector<Member> members, bool is_one_body) const;
  void sort_light_ones(const std::vector<RigidBody>& bodies);

  tree::Gravity::Parameters parameters_;
  double heavy_;
  std::vector<Crowd> crowds_;
  std::vector<std::uint32_t> id_;  ///< of the state's particles
  long evaluations_ = 0;
};

}  // namespace eerie::flight
