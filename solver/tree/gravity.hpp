#pragma once

#include <functional>
#include <vector>

#include "solver/base/tensor.hpp"
#include "solver/tree/kd_tree.hpp"

namespace eerie::tree {

/// Self-gravity of equal-mass particles by a Barnes-Hut walk over the kd tree: monopole and
/// quadrupole of a node of size b at distance d where b < theta d, else its particles one by
/// one, softened with the potential of the cubic spline inside 2h (Hernquist & Katz 1989,
/// appendix A). One bucket of targets walks once; sums over sources run in tree order.
class Gravity {
 public:
  struct Parameters {
    double particle_mass;  ///< kg
    double h;              ///< smoothing length, m; softening ends at 2h
    double opening_angle;  ///< theta; 0 makes a direct sum
  };
  explicit Gravity(const Parameters& p) : p_(p) {}

  /// Accelerations (m/s^2) at `x`, memory order; `tree` must be fitted to `x`.
  void accelerations(const KdTree& tree, const std::vector<Vec3>& x, std::vector<Vec3>& g);
  /// The same, handed to store(i, g_i) by several threads, each particle once.
  void accelerations(const KdTree& tree, const std::vector<Vec3>& x,
                     const std::function<void(std::size_t, const Vec3&)>& store);

  /// Of the particles at `sources`, which `tree` is fitted to, on those at `targets`; each in a kd
  /// order of its own.
  void accelerations(const KdTree& tree, const std::vector<Vec3>& sources,
                     const std::vector<Vec3>& targets,
                     const std::function<void(std::size_t, const Vec3&)>& store);

  /// Total potential energy, J; the same walk.
  double potential_energy(const KdTree& tree, const std::vector<Vec3>& x);

 private:
  struct Moments {
    Vec3 centre;            ///< of mass, m
    float count;            ///< mass in particle masses
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
