#pragma once

#include <variant>
#include <vector>

#include "solver/base/stages.hpp"
#include "solver/material/material.hpp"
#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"
#include "solver/sph/pair_sums.hpp"
#include "solver/tree/gravity.hpp"
#include "solver/tree/kd_tree.hpp"
#include "solver/tree/neighbour_list.hpp"

namespace eerie {

/// Integrates one State. Equations and scheme: docs/equations.md.
///
/// A predictor-corrector leapfrog with one evaluation of the elastic and frictional forces per
/// step. Gravity is evaluated every `gravity_interval` steps and extrapolated linearly in
/// between. A *cycle* is such a group of steps with one dt; runs are interrupted only between
/// cycles.
class Solver {
 public:
  /// Takes the state, sorts it into memory order and evaluates its first rates.
  Solver(const Scene& scene, State state);
  /// Goes on from a checkpoint: memory order, lists, rates and pressures as they were.
  Solver(const Scene& scene, State state, Rates rates, const Restart& restart,
         std::vector<double> pressure);

  /// One cycle of gravity_interval steps, shorter where `end_time` is near. Throws
  /// NumericalError when the state stops being physical.
  void cycle(double end_time);

  /// Multiplies all velocities; for settling bodies before a run.
  void damp(double factor);

  const State& state() const { return state_; }
  const Rates& rates() const { return rates_; }
  Restart restart() const { return {lists_.built_at()}; }
  const std::vector<double>& pressure() const { return pressure_; }
  double dt() const { return dt_; }
  const StageTimes& stages() const { return stages_; }
  StageTimes& stages() { return stages_; }
  long list_builds() const { return list_builds_; }

 private:
  using Sums = std::variant<PairSums<float, CubicSpline>, PairSums<float, WendlandC2>,
                            PairSums<float, WendlandC4>, PairSums<double, CubicSpline>,
                            PairSums<double, WendlandC2>, PairSums<double, WendlandC4>>;
  static Sums make_sums(const Scene& scene);

  void step();
  void evaluate_rates();
  void kick_and_drift();
  void update_lists();
  void reorder();
  void predict_material();
  void sum_over_neighbours();
  void final_kick();
  void evaluate_gravity(double elapsed);
  double gravity_age() const { return dt_ * static_cast<double>(since_gravity_); }
  Vec3 gravity(std::size_t i, double age) const { return rates_.g[i] + age * rates_.dg_dt[i]; }
  double time_step() const;
  void check(std::size_t offender, const char* kind) const;

  State state_;
  Rates rates_;
  Material material_;
  Sums sums_;
  Gravity gravity_;
  NeighbourList lists_;
  KdTree tree_;
  std::vector<SymTensor> S_predicted_;  ///< yielded, at the time of the rates
  std::vector<double> pressure_;        ///< at the time of the rates
  double cfl_;
  long gravity_interval_;
  long since_gravity_ = 0;  ///< steps since gravity was evaluated
  double dt_ = 0;
  long list_builds_ = 0;
  StageTimes stages_;
};

}  // namespace eerie
