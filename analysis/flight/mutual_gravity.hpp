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

/// The gravity of rigid bodies on each other, by their particles. A heavy body pulls the particles
/// of the others by its tree, which is fitted once, in the frame that turns with it. They pull back
/// as much: of two heavy bodies the smaller one's particles are asked. So a heavy body does not act
/// on itself. Light bodies act together, as one set of particles without net force or torque. So
/// momentum and angular momentum stay to rounding.
class MutualGravity {
 public:
  /// `heavy` is the least mass of a heavy body, kg.
  MutualGravity(const tree::Gravity::Parameters& parameters, double heavy)
      : parameters_(parameters), heavy_(heavy), light_gravity_(parameters) {}

  /// Sorts the members of heavy bodies into kd order. Call it first, and whenever bodies have
  /// changed by more than motion.
  void take(std::vector<RigidBody>& bodies, const std::vector<std::uint32_t>& id);

  /// The pull on every body at the present positions.
  std::vector<Pull> pulls(const std::vector<RigidBody>& bodies);

 private:
  /// Particles that are asked together, in a kd order, each by its body and its index in it.
  struct Crowd {
    struct Member {
      std::size_t body, k;
    };
    std::vector<Member> members;
    std::vector<Vec3> x;
  };
  struct Heavy {
    std::size_t body;
    Crowd particles;
    tree::KdTree tree;
    tree::Gravity gravity;
  };
  Heavy heavy(std::size_t b, const RigidBody& body) const;
  void sort_light_ones(const std::vector<RigidBody>& bodies);
  void pull(Heavy& source, const Crowd& crowd, const std::vector<RigidBody>& bodies,
            std::vector<Pull>& pulls);
  void pull_light_ones(const std::vector<RigidBody>& bodies, std::vector<Pull>& pulls);

  tree::Gravity::Parameters parameters_;
  double heavy_;
  std::vector<Heavy> heavy_ones_;  ///< the largest first
  Crowd light_;
  tree::Gravity light_gravity_;
  std::vector<std::uint32_t> id_;  ///< ids of the particles of the state
  std::vector<Vec3> seen_, g_;     ///< of the particles of one crowd
  long evaluations_ = 0;
};

}  // namespace eerie::flight
