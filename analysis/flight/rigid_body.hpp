#pragma once

#include <vector>

#include "analysis/remnants/clumps.hpp"
#include "solver/base/box.hpp"
#include "solver/base/tensor.hpp"
#include "solver/particles/state.hpp"

namespace eerie::flight {

/// A clump that moves as one rigid piece, SI. Its particles are `members` of a state; each stays at
/// x + R offset. Momentum and angular momentum are those of the particles that it was made of.
struct RigidBody {
  remnants::Clump members;
  std::vector<Vec3> offsets;       ///< from the centre of mass, as they were when it was made, m
  SymTensor inertia;               ///< about the centre of mass, as it was then, kg m^2
  double mass = 0, radius = 0;     ///< radius: of the sphere about x that holds all members
  Vec3 x, v;                       ///< of the centre of mass
  Vec3 L;                          ///< about it, kg m^2/s
  Mat3 turned = Mat3::identity();  ///< R: the rotation since it was made
  std::vector<Box> blocks;         ///< of block_size successive offsets each
  static constexpr std::size_t block_size = 64;
  bool in_kd_order = false;  ///< members and offsets (mutual_gravity.hpp)

  Vec3 place(std::size_t k) const { return x + turned * offsets[k]; }
  /// Where it is and how it is turned: all that free motion changes.
  struct Place {
    Vec3 x;
    Mat3 turned;
  };
  Place place() const { return {x, turned}; }
  void move_to(const Place& there) { x = there.x, turned = there.turned; }
  /// rad/s; nothing turns about a line of particles, or in a single one.
  Vec3 angular_velocity() const;
  /// Force and torque act for `duration` s.
  void kick(const Vec3& force, const Vec3& torque, double duration) {
    v += (duration / mass) * force, L += duration * torque;
  }
  /// Moves and turns freely for `duration` s: torque-free rotation by the midpoint rule, of second
  /// order; L stays as it is.
  void drift(double duration);
  /// Members and offsets in another order: number k is what was number order[k].
  void reorder(const std::vector<std::uint32_t>& order);
};

/// Whether the least distance between any two of their particles is below `contact`, m.
bool touch(const RigidBody& one, const RigidBody& other, double contact);

/// The members of a state as one rigid body.
RigidBody rigid_body(const particles::State& state, remnants::Clump members);

/// What two bodies are once they stick: the same mass, centre, momentum and angular momentum, less
/// the energy of their relative motion. Its frame is that of the larger one, into which the
/// stresses of the other one's particles are turned.
RigidBody stuck_together(RigidBody one, RigidBody other, particles::State& state);

/// Gives the particles of a body the places and velocities of its rigid motion, and turns their
/// stresses by as much as the body has turned since it was made.
void put_back(const RigidBody& body, particles::State& state);

}  // namespace eerie::flight
