#include "solver/step/solver.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/sph/stress.hpp"

namespace eerie {

namespace {

/// Limit from accelerations, dt <= 0.25 sqrt(h/|a|) (Monaghan 1992).
constexpr double acceleration_safety = 0.25;
constexpr std::size_t nobody = static_cast<std::size_t>(-1);

}  // namespace

Solver::Sums Solver::make_sums(const Scene& scene) {
  const double h = smoothing_length(scene);
  const Viscosity viscosity{scene.numerics.viscosity_alpha, scene.numerics.viscosity_beta};
  return std::visit(
      [&](auto kernel) -> Sums {
        using Kernel = decltype(kernel);
        if (scene.numerics.precision == "double") return PairSums<double, Kernel>(h, viscosity);
        return PairSums<float, Kernel>(h, viscosity);
      },
      make_kernel(scene.numerics.kernel));
}

Solver::Solver(const Scene& scene, State state)
    : Solver(scene, std::move(state), Rates{}, Restart{}, {}) {}

Solver::Solver(const Scene& scene, State state, Rates rates, const Restart& restart,
               std::vector<double> pressure)
    : state_(std::move(state)),
      rates_(std::move(rates)),
      material_(make_material(scene)),
      sums_(make_sums(scene)),
      gravity_({state_.mass, state_.h, scene.numerics.opening_angle}),
      lists_(2 * state_.h, 2 * state_.h * scene.numerics.list_skin),
      tree_(state_.size()),
      pressure_(std::move(pressure)),
      cfl_(scene.numerics.cfl),
      gravity_interval_(scene.numerics.gravity_interval) {
  const std::size_t n = state_.size();
  S_predicted_.resize(n);
  pressure_.resize(n);
  std::visit([n](auto& sums) { sums.rows.resize(n); }, sums_);
  const bool fresh = restart.list_x.empty();
  if (fresh) {
    resize(rates_, n);
    reorder();
    tree_.fit(state_.x);
    lists_.build(tree_, state_.x);
    evaluate_rates();  // for the correction matrices
    evaluate_rates();
    evaluate_gravity(0);
  } else {
    tree_.fit(restart.list_x);
    lists_.build(tree_, restart.list_x);
  }
}

void Solver::cycle(double end_time) {
  dt_ = time_step();
  const double left = end_time - state_.time;
  const auto steps_left = static_cast<long>(std::ceil(left / dt_ * (1 - 1e-12)));
  const long steps = std::min(gravity_interval_, std::max(1L, steps_left));
  if (steps_left <= gravity_interval_) dt_ = left / static_cast<double>(steps);
  for (since_gravity_ = 0; since_gravity_ < steps;) step();
  evaluate_gravity(dt_ * static_cast<double>(steps));
}

void Solver::step() {
  kick_and_drift();
  update_lists();
  evaluate_rates();
  final_kick();
  state_.time += dt_;
  ++state_.step;
  ++since_gravity_;
}

void Solver::evaluate_rates() {
  predict_material();
  sum_over_neighbours();
}

/// Half a kick with the old rates, then the drift. Density and stress move half a step too; the
/// other half of the prediction is added on the fly where rates are evaluated.
void Solver::kick_and_drift() {
  const StageTimer timer(stages_, Stage::integrate);
  const double half = 0.5 * dt_, age = gravity_age();
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < state_.size(); ++i) {
    state_.v[i] += half * (rates_.dv_dt[i] + gravity(i, age));
    state_.x[i] += dt_ * state_.v[i];
    state_.rho[i] += half * rates_.drho_dt[i];
    state_.S[i] += half * rates_.dS_dt[i];
  }
}

void Solver::update_lists() {
  {
    const StageTimer timer(stages_, Stage::neighbours);
    if (!lists_.used_up(state_.x)) return;
  }
  {
    const StageTimer timer(stages_, Stage::reorder);
    reorder();
  }
  const StageTimer timer(stages_, Stage::neighbours);
  tree_.fit(state_.x);
  lists_.build(tree_, state_.x);
  ++list_builds_;
}

void Solver::reorder() {
  const std::vector<std::uint32_t> order = kd_order(state_.x, state_.id);
  visit_state(state_, [&](const char*, auto& array) { permute(array, order); });
  visit_rates(rates_, [&](const char*, auto& array) { permute(array, order); });
}

/// Pressure, sound speed and yielded stress of the predicted state; the rows for pair sums.
void Solver::predict_material() {
  const StageTimer timer(stages_, Stage::material);
  const double half = 0.5 * dt_, age = gravity_age();
  std::size_t offender = nobody;
  std::visit(
      [&](auto& sums, const auto& eos, const auto& rheology) {
#pragma omp parallel for schedule(static) reduction(min : offender)
        for (std::size_t b = 0; b < bucket_count(state_.size()); ++b) {
          const std::size_t first = b * bucket_size;
          const std::size_t last = std::min(first + bucket_size, state_.size());
          sums.rows.set_origin(b, state_.x[first], state_.v[first]);
          for (std::size_t i = first; i < last; ++i) {
            const double rho = state_.rho[i] + half * rates_.drho_dt[i];
            if (!(rho > 0)) offender = std::min(offender, i);
            const EosPoint point = eos(rho, 0.0);
            const double p = rheology.pressure(point.p);
            pressure_[i] = p;
            S_predicted_[i] = rheology.yielded(state_.S[i] + half * rates_.dS_dt[i], p);
            const Vec3 v = state_.v[i] + half * (rates_.dv_dt[i] + gravity(i, age));
            sums.rows.set(i, state_.x[i], v, state_.mass / rho, rho, point.c);
            // The dual of the corrected gradient, T = -p 1 + S L; L is one step old (it follows
            // the arrangement of the neighbours, which hardly moves in a step).
            Mat3 T = to_matrix(S_predicted_[i]) * to_matrix(rates_.correction[i]);
            for (int k = 0; k < 3; ++k) T[k][k] -= p;
            sums.rows.set_flux(i, T);
          }
        }
      },
      sums_, material_.eos, material_.rheology);
  check(offender, "negative-density");
}

/// All neighbour sums in one visit; from them the corrected velocity gradient and the rates of
/// density, stress and velocity.
void Solver::sum_over_neighbours() {
  const StageTimer timer(stages_, Stage::pairs);
  const double half = 0.5 * dt_;
  std::visit(
      [&](const auto& sums) {
        sums.sweep(lists_, state_.size(), [&](std::size_t i, const NeighbourSums& s) {
          const double rho = state_.rho[i] + half * rates_.drho_dt[i];
          const SymTensor L = correction_matrix(s.C);
          rates_.correction[i] = L;
          rates_.drho_dt[i] = -rho * (s.G[0][0] + s.G[1][1] + s.G[2][2]);
          rates_.dS_dt[i] =
              stress_rate(S_predicted_[i], s.G * to_matrix(L), material_.shear_modulus);
          rates_.dv_dt[i] = s.force / rho;
        });
      },
      sums_);
}

/// The other half with the new rates; the stress returns to the yield surface.
void Solver::final_kick() {
  const StageTimer timer(stages_, Stage::integrate);
  const double half = 0.5 * dt_, age = gravity_age() + dt_;
  std::size_t offender = nobody;
  std::visit(
      [&](const auto& rheology) {
#pragma omp parallel for schedule(static) reduction(min : offender)
        for (std::size_t i = 0; i < state_.size(); ++i) {
          state_.v[i] += half * (rates_.dv_dt[i] + gravity(i, age));
          state_.rho[i] += half * rates_.drho_dt[i];
          state_.S[i] = rheology.yielded(state_.S[i] + half * rates_.dS_dt[i], pressure_[i]);
          if (!is_finite(state_.v[i]) || !std::isfinite(trace(state_.S[i]) + state_.rho[i]))
            offender = std::min(offender, i);
        }
      },
      material_.rheology);
  check(offender, "not-finite");
}

/// Gravity anew, and its rate from the evaluation `elapsed` seconds ago (0: there was none).
/// Between evaluations it goes on linearly. Holding it constant would twist every spinning body;
/// kicking it in lumps would shake a resting one, so that viscosity, not friction, carries it.
void Solver::evaluate_gravity(double elapsed) {
  const StageTimer timer(stages_, Stage::gravity);
  tree_.fit(state_.x);
  const std::vector<Vec3> before = rates_.g;
  gravity_.accelerations(tree_, state_.x, rates_.g);
  for (std::size_t i = 0; i < state_.size(); ++i)
    rates_.dg_dt[i] = elapsed > 0 ? (rates_.g[i] - before[i]) / elapsed : Vec3{};
}

/// dt = cfl h/(c_l + h |div v|) with the longitudinal wave c_l^2 = c^2 + 4G/(3 rho), and
/// 0.25 sqrt(h/|a|); a function of state and rates alone, so a restart finds the same.
double Solver::time_step() const {
  double fastest = 0, strongest = 0;
  std::visit(
      [&](const auto& eos) {
#pragma omp parallel for schedule(static) reduction(max : fastest, strongest)
        for (std::size_t i = 0; i < state_.size(); ++i) {
          const double rho = state_.rho[i], c = eos(rho, 0.0).c;
          // Expanded damaged material carries no stress, so no wave faster than the reference.
          const double inertia = std::max(rho, material_.reference_density);
          const double wave = std::sqrt(c * c + 4 * material_.shear_modulus / (3 * inertia));
          const double divergence = std::abs(rates_.drho_dt[i]) / rho;
          fastest = std::max(fastest, wave + state_.h * divergence);
          strongest = std::max(strongest, norm2(rates_.dv_dt[i]));
        }
      },
      material_.eos);
  const double signal = cfl_ * state_.h / fastest;
  if (strongest == 0) return signal;
  return std::min(signal, acceleration_safety * std::sqrt(state_.h / std::sqrt(strongest)));
}

void Solver::damp(double factor) {
  for (Vec3& v : state_.v) v *= factor;
}

void Solver::check(std::size_t offender, const char* kind) const {
  if (offender == nobody) return;
  const auto id = static_cast<long>(state_.id[offender]);
  throw NumericalError(
      kind, state_.step, id,
      fmt::format("{} at step {} (t = {:.6g} s), particle {}: rho = {:.4g} kg/m^3, "
                  "|v| = {:.4g} m/s; lower numerics.cfl (now {:g}) or look at the "
                  "last good state",
                  kind, state_.step, state_.time, id, state_.rho[offender],
                  norm(state_.v[offender]), cfl_));
}

}  // namespace eerie
