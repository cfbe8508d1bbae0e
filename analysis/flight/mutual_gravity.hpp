#pragma once

#include <cstdint>
#include <vector>

#include "analysis/flight/rigid_body.hpp"
#include "solver/tree/gravity.hpp"
#include "solver/tree/kd_tree.hpp"

namespace eerie::flight {

/// The force on a body, N, and the torque about its centre of mass, N m.
struct Pull {
  Vec3 force, torque;
};

/// The gravity of rigid bodies on each other, by their particles. A heavy body does not act on
/// itself: the tree's forces within a body do not sum exactly to zero, and over a long flight the
/// remainder would move it. Light bodies act together, as one set of particles.
class MutualGravity {
 public:
  /// `heavy` is the least mass of a heavy body, kg.
  MutualGravity(const tree::Gravity::Parameters& parameters, double heavy)
      : parameters_(parameters), heavy_(heavy) {}

  /// Sorts the members of heavy bodies into kd order. Call it first, and whenever bodies have
  /// changed by more than motion.
  void take(std::vector<RigidBody>& bodies, const std::vector<std::uint32_t>& id);

  /// The pull on every body at the present positions.
  std::vector<Pull> pulls(const std::vector<RigidBody>& bodies);

 private:
  /// A particle, by its body and its index in it.
  struct Member {
    std::size_t body, k;
  };
  /// Particles that act together, in kd order.
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
  std::vector<std::uint32_t> id_;  ///< ids of the particles of the state
  long evaluations_ = 0;
};

}  // namespace eerie::flight
