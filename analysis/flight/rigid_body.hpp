#pragma once

#include <vector>

#include "analysis/remnants/clumps.hpp"
#include "solver/base/box.hpp"
#include "solver/base/tensor.hpp"
#include "solver/particles/state.hpp"

namespace eerie::flight {

/// A clump that moves as one rigid body, in SI. Its particles are `members` of a state, and each
/// stays at x + R offset. Its momentum and angular momentum are the sums over its particles.
struct RigidBody {
  remnants::Clump members;
  std::vector<Vec3> offsets;       ///< from the centre of mass when the body was made, m
  SymTensor inertia;               ///< about the centre of mass when the body was made, kg m^2
  double mass = 0, radius = 0;     ///< radius of the sphere about x that contains all members
  Vec3 x, v;                       ///< of the centre of mass
  Vec3 L;                          ///< angular momentum about x, kg m^2/s
  Mat3 turned = Mat3::identity();  ///< R, the rotation since the body was made
  std::vector<Box> blocks;         ///< of block_size successive offsets each
  static constexpr std::size_t block_size = 64;
  bool in_kd_order = false;  ///< members and offsets (mutual_gravity.hpp)

  Vec3 place(std::size_t k) const { return x + turned * offsets[k]; }
  /// Position and orientation, which are all that free motion changes.
  struct Place {
    Vec3 x;
    Mat3 turned;
  };
  Place place() const { return {x, turned}; }
  void move_to(const Place& there) { x = there.x, turned = there.turned; }
  /// The angular velocity, rad/s. It is 0 for particles on a line and for a single particle.
  Vec3 angular_velocity() const;
  /// Lets force and torque act for `duration`, s.
  void kick(const Vec3& force, const Vec3& torque, double duration) {
    v += (duration / mass) * force, L += duration * torque;
  }
  /// Moves and turns freely for `duration`, s. The midpoint rule, of second order, advances the
  /// torque-free rotation and keeps L.
  void drift(double duration);
  /// Reorders members and offsets: index k becomes index order[k].
  void reorder(const std::vector<std::uint32_t>& order);
};

/// Whether any two of their particles are closer than `contact`, m.
bool touch(const RigidBody& one, const RigidBody& other, double contact);

/// Makes one rigid body of these members of a state.
RigidBody rigid_body(const particles::State& state, remnants::Clump members);

/// Joins two bodies that stick. Mass, centre, momentum and angular momentum stay; the energy of
/// their relative motion is lost. The frame of the larger body remains, and the stresses of the
/// other one's particles are turned into it.
RigidBody stuck_together(RigidBody one, RigidBody other, particles::State& state);

/// Sets the positions and velocities of a body's particles to its rigid motion, and turns their
/// stresses by the rotation of the body since it was made.
void put_back(const RigidBody& body, particles::State& state);

}  // namespace eerie::flight
