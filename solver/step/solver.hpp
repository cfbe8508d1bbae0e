#pragma once

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include "solver/base/stages.hpp"
#include "solver/material/of_bodies.hpp"
#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"
#include "solver/sph/pair_sums.hpp"
#include "solver/sph/stress.hpp"
#include "solver/step/chebyshev_stages.hpp"
#include "solver/step/integrator.hpp"
#include "solver/tree/gravity.hpp"
#include "solver/tree/kd_tree.hpp"
#include "solver/tree/neighbour_list.hpp"

namespace eerie::step {

/// Integrates one State under the laws of a Scene; it does not use the scene's bodies and impact.
/// docs/explanation/equations.md has the equations and the scheme.
///
/// The default staggers stress against velocity: one visit of the neighbours for the velocity
/// gradient and one for the forces per step. Gravity changes slowly, so it is evaluated once per
/// *cycle* of steps and extrapolated linearly in between. `gravity_tolerance` limits the length of
/// a cycle. All steps of a cycle have one dt, and runs are interrupted only between cycles.
class Solver {
 public:
  /// Takes the state, sorts it into memory order and evaluates its first rates. Where the state
  /// lacks fields of optional physics, its energy starts at zero and its material undamaged.
  Solver(const Scene& scene, particles::State state);
  /// One that is only looked at: pressures and what viscosity carries are those of the state. Its
  /// forces lack their corrections, which need a sum before, and gravity; no neighbourhood is too
  /// poor for it.
  static Solver for_sums(const Scene& scene, particles::State state);
  /// Continues from a checkpoint with its memory order, lists, rates and pressures. From an empty
  /// `restart` nothing is evaluated yet.
  Solver(const Scene& scene, particles::State state, particles::Rates rates,
         const particles::Restart& restart, std::vector<double> pressure);

  /// Makes one cycle of steps, a shorter one where `end_time` is near. Throws NumericalError where
  /// the state stops being physical; the state is then useless.
  void cycle(double end_time);

  /// Multiplies all velocities relative to a rotation `omega` (rad/s) about the origin by a factor.
  /// It damps bodies that settle before a run.
  void damp(double factor, const Vec3& omega = {});
  /// Adds a rotation `omega` (rad/s) about the origin to all velocities.
  void spin_up(const Vec3& omega);

  const particles::State& state() const { return state_; }
  const particles::Rates& rates() const { return rates_; }
  particles::Restart restart() const {
    return {lists_.built_at(), lists_.support(), builds_in_order_};
  }
  const std::vector<double>& pressure() const { return pressure_; }
  const material::OfBodies& materials() const { return materials_; }
  const tree::NeighbourList& lists() const { return lists_; }
  double dt() const { return dt_; }
  const StageTimes& stages() const { return stages_; }
  StageTimes& stages() { return stages_; }
  long list_builds() const { return list_builds_; }
  /// The number of particles that had too few neighbours for a corrected gradient at the last
  /// evaluation.
  long uncorrected() const { return uncorrected_; }

  // These are the moves of an integrator (integrator.hpp).
  void kick_and_drift(double kick, double drift);
  void evaluate(double ahead);
  void kick(double duration);
  // These are the moves of a staggered integrator (staggered.cpp).
  void push_and_drift(double push, double drift);
  void deform(double duration);
  void exert(double ahead);
  void push(double duration);

 private:
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);
  template <sph::Terms terms>
  using SumsOf = std::variant<
      sph::PairSums<float, sph::CubicSpline, terms>, sph::PairSums<float, sph::WendlandC2, terms>,
      sph::PairSums<float, sph::WendlandC4, terms>, sph::PairSums<double, sph::CubicSpline, terms>,
      sph::PairSums<double, sph::WendlandC2, terms>, sph::PairSums<double, sph::WendlandC4, terms>>;
  using Sums = std::variant<SumsOf<sph::Terms::basic>, SumsOf<sph::Terms::shear_free>,
                            SumsOf<sph::Terms::all>>;
  Sums make_sums() const;
  template <class Visit>
  void visit_sums(Visit&& visit) {
    std::visit([&](auto& family) { std::visit(visit, family); }, sums_);
  }

  /// What the pair sums need of a particle besides the arrays of this class.
  struct Predicted {
    double rho, c;
  };
  /// How far the rows of the pair sums are ahead of the state, s, and whether the state itself
  /// takes the yielded stress.
  struct Ahead {
    double velocity, stress;
    bool is_final = false;
  };
  /// How one step strains a particle, and the stress and density that follow.
  struct Strained {
    Mat3 G;               ///< uncorrected velocity gradient in the middle of the step, 1/s
    SymTensorf L_before;  ///< correction of the forces at the beginning of the step
    SymTensor trial;      ///< stress before yielding, Pa
    double rho_after;     ///< kg/m^3
  };
  enum class Gradient { corrected_fully, corrected, corrected_rate, plain };

  void step();
  void heat(double duration);
  void turn_back(double drift);
  void update_lists();
  void reorder();
  void find_voids();
  void close_voids();
  bool is_void(std::size_t i) const { return !is_void_.empty() && is_void_[i]; }
  void apply_material(Ahead ahead);
  void apply_laws(std::size_t bucket, double ahead, std::array<Predicted, tree::bucket_size>& out);
  void fill_rows(std::size_t bucket, Ahead ahead,
                 const std::array<Predicted, tree::bucket_size>& predicted);
  void sum_over_neighbours(double ahead);
  std::size_t set_rates(std::size_t i, std::size_t count, double ahead,
                        const sph::PackedSums& sums);
  bool is_at_wall(std::size_t i) const;
  bool is_inside_primary(std::size_t i) const;
  void set_heating(std::size_t i, double ahead, const sph::NeighbourSums& sums);
  bool is_surrounded(std::size_t i) const;
  std::size_t first_collapsed(std::size_t i, std::size_t count, const sph::PackedSums& sums,
                              const Pack<double>& rho) const;
  void check_collapse(std::size_t singular) const;
  void set_middle_rows(double duration);
  bool viscosity_lags() const;
  void sum_forces(double ahead);
  void begin_stages(std::size_t i, const sph::PackedSums& sums, std::size_t l);
  void damp_in_stages();
  std::size_t go_on(std::size_t i, std::size_t count, double duration, const sph::PackedSums& sums);
  void heat_by_viscosity(double duration);
  void heat_by_strain(std::size_t i, double duration, const Strained& now);
  void heat_by_brake(std::size_t i, const Vec3& change, const sph::PackedSums& sums,
                     std::size_t lane);
  void set_forces(std::size_t i, std::size_t count, const sph::PackedSums& sums);
  Vec3 acceleration_by_viscosity(std::size_t i, const sph::PackedSums& sums,
                                 std::size_t lane) const;
  void grow_damage(double duration);
  void evaluate_gravity(double elapsed, double planned);
  bool knows_gravity_rate() const;
  bool is_staggered() const { return std::holds_alternative<Staggered>(integrator_); }

  /// Whether cohesion has ended at a particle: it hangs on too few others.
  bool is_frayed(std::size_t i) const { return frays_ && sph::is_frayed(rates_.correction[i]); }
  /// The pressure that friction uses, Pa.
  double confining_pressure(std::size_t i) const {
    return fields_.viscous_pressure ? pressure_[i] + rates_.viscous_pressure[i] : pressure_[i];
  }
  double predicted_density(std::size_t i, double ahead) const {
    return particles::changed_density(state_.rho[i], ahead * rates_.drho_dt[i]);
  }
  /// The density that gives the volume of a particle in the sums, kg/m^3.
  double filling_density(double rho) const { return std::max(rho, thinnest_); }
  double reference_density(std::size_t i) const {
    return materials_.reference_density(state_.body[i]);
  }
  double smoothing_length(std::size_t i, double rho) const;
  double largest_support() const;
  material::Condition condition(std::size_t i, double ahead) const;
  SymTensor predicted_stress(std::size_t i, double ahead) const;
  sph::FluxRows momentum_flux(std::size_t i, double ahead) const;
  SymTensor artificial_stress(std::size_t i, double ahead) const;
  double gravity_age() const { return dt_ * static_cast<double>(since_gravity_); }
  Vec3 gravity(std::size_t i, double age) const {
    return Vec3(rates_.g[i]) + age * Vec3(rates_.dg_dt[i]);
  }
  double stiffening(std::size_t i) const;
  /// What limits dt, s. Viscosity allows so much where it damps in one stage.
  struct Limits {
    double motion, viscosity;
    double with(const ChebyshevStages& stages) const {
      // Several stages damp the shortest waves less than one does: rubble rests up to cfl 1.0.
      constexpr double for_rest = 0.91;
      return std::min(stages.count() > 1 ? for_rest * motion : motion, stages.reach() * viscosity);
    }
  };
  Limits time_step_limits() const;
  ChebyshevStages cheapest_stages(const Limits& limits) const;
  void take_stages(const Limits& limits);
  long steps_in_cycle() const;

  void expect_speeds();
  void check_positions();
  void check(std::size_t offender, const char* kind, const char* remedy) const;

  Scene scene_;
  particles::State state_;
  particles::Rates rates_;
  material::OfBodies materials_;
  particles::OptionalFields fields_;
  Gradient gradient_;
  double thinnest_;        ///< see filling_density, kg/m^3
  bool stressed_surface_;  ///< whether free surfaces carry stress, by tensile strength or cohesion
  bool frays_;             ///< whether that is cohesion of rubble, which ends where matter frays
  material::Flaws flaws_;
  std::vector<tree::Mirror> walls_;
  bool evolving_h_;
  std::array<double, 2> constant_h_;  ///< of each body where h does not evolve, m
  bool sees_voids_;
  Sums sums_;
  Integrator integrator_;
  tree::Gravity gravity_;
  tree::NeighbourList lists_;
  tree::KdTree tree_;
  /// Fraction of the predicted stress that remains after yielding.
  std::vector<float> yield_factor_;
  std::vector<double> pressure_;  ///< at the time of the rates
  /// Whether a particle has a void around it; empty without numerics.voids.
  std::vector<std::uint8_t> is_void_;
  ChebyshevStages stages_of_viscosity_;  ///< of this cycle
  /// The changes of velocity by the last one and the one before; empty where there is but one.
  std::vector<Vec3> change_, change_before_;
  bool goes_on_ = true;     ///< false of a solver that is only looked at
  long since_gravity_ = 0;  ///< steps since gravity was evaluated
  double dt_ = 0;
  long list_builds_ = 0, builds_in_order_ = 0, uncorrected_ = 0;
  /// No particle is further from the origin than reach + fastest_expected (t - begun).
  double reach_ = 0, fastest_expected_ = 0, begun_ = 0;
  StageTimes stages_;
};

}  // namespace eerie::step
