#pragma once

#include <functional>
#include <vector>

#include "solver/base/rigid_field.hpp"
#include "solver/base/tensor.hpp"
#include "solver/tree/kd_tree.hpp"

namespace eerie::tree {

/// Self-gravity of particles of equal mass, by a Barnes-Hut walk over the kd tree. A node of size b
/// at distance d acts by its monopole and quadrupole where b < theta d; otherwise its particles act
/// one by one. Inside 2h the potential of the cubic spline softens them (Hernquist & Katz 1989,
/// appendix A). The tree is walked once per bucket of targets, and sums over sources run in tree
/// order.
class Gravity {
 public:
  struct Parameters {
    double particle_mass;  ///< kg
    double h;              ///< smoothing length, m; softening ends at 2h
    double opening_angle;  ///< theta; 0 makes a direct sum
  };
  explicit Gravity(const Parameters& p) : p_(p) {}

  /// Computes the accelerations (m/s^2) at `x`, in memory order, without net force or torque.
  /// `tree` must be fitted to `x`.
  void accelerations(const KdTree& tree, const std::vector<Vec3>& x, std::vector<Vec3>& g);
  /// Hands each acceleration to store(i, g_i). Several threads call it, once per particle. Returns
  /// what is to be taken off: particles that attract each other have neither net force nor torque.
  /// A tree that opens nodes from one side has both, as its errors do. The rigid field that takes
  /// them away is the least one, so what is left is nearer to the true field in the mean square.
  [[nodiscard]] RigidField accelerations(
      const KdTree& tree, const std::vector<Vec3>& x,
      const std::function<void(std::size_t, const Vec3&)>& store);

  /// Computes the accelerations (m/s^2) at `targets` by the particles at `sources`, to which `tree`
  /// is fitted. Both arrays are in a kd order of their own.
  void accelerations(const KdTree& tree, const std::vector<Vec3>& sources,
                     const std::vector<Vec3>& targets,
                     const std::function<void(std::size_t, const Vec3&)>& store);

  /// The total potential energy, J, by the same walk.
  double potential_energy(const KdTree& tree, const std::vector<Vec3>& x);

 private:
  struct Moments {
    Vec3 centre;            ///< centre of mass, m
    float count;            ///< mass, in units of a particle's mass
    float size;             ///< largest distance of a corner of the box from the centre, m
    SymTensorf quadrupole;  ///< sum of 3 x x - r^2 1, m^2
  };
  void fit_moments(const KdTree& tree, const std::vector<Vec3>& x);
  template <bool potential, class Store>
  void walk(const KdTree& tree, const std::vector<Vec3>& sources, const std::vector<Vec3>& targets,
            Store&& store);

  Parameters p_;
  std::vector<Moments> moments_;
};

}  // namespace eerie::tree
