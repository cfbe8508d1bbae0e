#include "solver/step/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/base/principal.hpp"
#include "solver/io/snapshot.hpp"
#include "solver/step/late.hpp"
#include "solver/step/walls.hpp"

namespace eerie::step {

namespace {

/// Particles are sorted again with every so many list builds: their order decays slowly.
constexpr long builds_per_order = 8;
/// Limit from accelerations, dt <= 0.25 sqrt(h/|a|) (Monaghan 1992).
constexpr double acceleration_safety = 0.25;
/// Viscosity damps the shortest waves of packed particles at up to 1.66 alpha c/h (the largest
/// eigenvalue of its pair sums where all pairs approach). A staggered step damps stably up to
/// 1/dt where forces see predicted velocities, and up to 2/dt where they see those of the half
/// step.
constexpr double viscous_safety = 0.6, lagging_viscous_safety = 1.0;
/// Streams 0 and 1 of random numbers pack the bodies.
constexpr std::uint64_t flaw_stream = 2;
/// Support radius of a list build over the largest one in use, where h evolves.
constexpr double growth_room = 1.02;
/// A particle that has lost its neighbours is no larger in sums than at this part of the reference
/// density. Gradients that are corrected in every term do not depend on volumes; with those of
/// lone particles growing without bound, the sums of their last neighbours would be theirs alone.
constexpr double thinnest_filling = 0.2;

/// With alpha h and beta h^2 of the particles that the scene names.
sph::Viscosity viscosity_of(const Scene& scene) {
  const double ratio = viscosity_length_ratio(scene);
  return {ratio * scene.numerics.viscosity_alpha, ratio * ratio * scene.numerics.viscosity_beta};
}

}  // namespace

Solver::Sums Solver::make_sums() const {
  const Scene::Numerics& n = scene_.numerics;
  const sph::Viscosity viscosity = viscosity_of(scene_);
  const sph::ExtraTerms extra{evolving_h_ || materials_.has_two_densities(),
                              n.artificial_stress > 0,
                              std::cbrt(state_.mass / materials_.lowest_density()), fields_.shear};
  const bool all =
      fields_.energy || fields_.viscous_pressure || extra.unlike_h || extra.artificial_stress;
  return std::visit(
      [&](auto kernel) -> Sums {
        using Kernel = decltype(kernel);
        const auto make = [&]<sph::Terms t>(std::integral_constant<sph::Terms, t>) -> Sums {
          if (n.precision == "double")
            return SumsOf<t>(
                sph::PairSums<double, Kernel, t>(state_.h, state_.mass, viscosity, extra));
          return SumsOf<t>(
              sph::PairSums<float, Kernel, t>(state_.h, state_.mass, viscosity, extra));
        };
        if (all) return make(std::integral_constant<sph::Terms, sph::Terms::all>{});
        if (fields_.shear)
          return make(std::integral_constant<sph::Terms, sph::Terms::shear_free>{});
        return make(std::integral_constant<sph::Terms, sph::Terms::basic>{});
      },
      sph::make_kernel(n.kernel));
}

Solver::Solver(const Scene& scene, particles::State state)
    : Solver(scene, std::move(state), particles::Rates{}, particles::Restart{}, {}) {
  evaluate(0);  // for the correction matrices
  evaluate(0);
  evaluate_gravity(0, 0);
}

Solver Solver::for_sums(const Scene& scene, particles::State state) {
  Solver solver(scene, std::move(state), particles::Rates{}, particles::Restart{}, {});
  solver.goes_on_ = false;
  solver.evaluate(0);
  if (solver.fields_.shear) solver.evaluate(0);  // viscosity needs the shear of a sum before
  return solver;
}

Solver::Solver(const Scene& scene, particles::State state, particles::Rates rates,
               const particles::Restart& restart, std::vector<double> pressure)
    : scene_(softened(scene, state.softening)),
      state_(std::move(state)),
      rates_(std::move(rates)),
      materials_(scene_),
      fields_(io::optional_fields(scene)),
      gradient_(scene.numerics.gradient == "corrected-fully"  ? Gradient::corrected_fully
                : scene.numerics.gradient == "corrected"      ? Gradient::corrected
                : scene.numerics.gradient == "corrected-rate" ? Gradient::corrected_rate
                                                              : Gradient::plain),
      thinnest_(gradient_ == Gradient::corrected_fully
                    ? thinnest_filling * materials_.lowest_density()
                    : 0),
      stressed_surface_(materials_.has_stressed_surface()),
      frays_(stressed_surface_ && materials_.target().initial_damage() == 1),
      walls_(mirrors(scene.environment)),
      evolving_h_(scene.numerics.smoothing == "evolving"),
      constant_h_({state_.h * particle_sizes(scene)[0], state_.h * particle_sizes(scene)[1]}),
      sees_voids_(scene.numerics.void_density > 0 &&
                  (scene.numerics.voids == "all" ||
                   (materials_.target().closes_gaps() && !stressed_surface_))),
      sums_(make_sums()),
      integrator_(
          make_by_token<Integrator>("scene.numerics.integrator", scene.numerics.integrator)),
      gravity_({state_.mass, state_.h, scene.numerics.opening_angle}),
      lists_(2 * state_.h, 2 * state_.h * scene.numerics.list_skin, tree::images_of(walls_),
             scene.numerics.precision == "double" ? row_units<double> : row_units<float>),
      tree_(state_.size()),
      pressure_(std::move(pressure)) {
  const std::size_t n = state_.size();
  require_walls_apart(scene.environment, lists_.support() * (1 + scene.numerics.list_skin));
  particles::resize(state_, n, fields_);
  yield_factor_.resize(n);
  pressure_.resize(n);
  visit_sums([n](auto& sums) { sums.rows.resize(n); });
  if (const auto* law = std::get_if<material::GradyKipp>(&materials_.target().fracture)) {
    Random random(static_cast<std::uint64_t>(scene.numerics.seed), flaw_stream);
    flaws_ = law->deal(
        n, state_.mass * static_cast<double>(n) / materials_.target().reference_density, random);
  }
  expect_speeds();
  if (restart.list_x.empty()) {
    particles::resize(rates_, n, fields_);
    reorder();
    tree_.fit(state_.x);
    lists_.set_support(largest_support());
    lists_.build(tree_, state_.x);
  } else {
    tree_.fit(restart.list_x);
    lists_.set_support(restart.list_support);
    builds_in_order_ = restart.builds_in_order;
    lists_.build(tree_, restart.list_x);
  }
}

void Solver::cycle(double end_time) {
  find_voids();
  const Limits limits = time_step_limits();
  dt_ = limits.with(cheapest_stages(limits));
  const double left = end_time - state_.time;
  const auto steps_left = static_cast<long>(std::ceil(left / dt_ * (1 - 1e-12)));
  const long interval = steps_in_cycle();
  const double planned = dt_ * static_cast<double>(interval);
  const long steps = std::min(interval, std::max(1L, steps_left));
  if (steps_left <= interval) dt_ = left / static_cast<double>(steps);
  take_stages(limits);
  for (since_gravity_ = 0; since_gravity_ < steps;) step();
  evaluate_gravity(dt_ * static_cast<double>(steps), planned);
  check_positions();
}

void Solver::step() {
  std::visit([this](auto integrator) { integrator.step(*this, dt_); }, integrator_);
  close_voids();
  if (fields_.damage) grow_damage(dt_);
  state_.time += dt_;
  ++state_.step;
  ++since_gravity_;
}

void Solver::kick_and_drift(double kick, double drift) {
  {
    const StageTimer timer(stages_, Stage::integrate);
    const double age = gravity_age();
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < state_.size(); ++i) {
      state_.v[i] += kick * (rates_.dv_dt[i] + gravity(i, age));
      state_.x[i] += drift * state_.v[i];
      state_.rho[i] = particles::changed_density(state_.rho[i], kick * rates_.drho_dt[i]);
      state_.S[i] += kick * rates_.dS_dt[i];
    }
    if (fields_.energy) heat(kick);
    if (!walls_.empty()) turn_back(drift);
  }
  update_lists();
}

/// A particle that has just crossed a wall met its own image on the way, and the two change places:
/// for all others nothing happens. Loose grains below the reference density have no pressure to
/// stop them before.
void Solver::turn_back(double drift) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const Vec3 before = state_.x[i] - drift * state_.v[i];
    for (const tree::Mirror& wall : walls_) {
      const auto inside = [&](double at) { return (at >= wall.at) == wall.low; };
      if (inside(state_.x[i][wall.axis]) || !inside(before[wall.axis])) continue;
      const tree::MirrorImage image = tree::reflected({}, wall);
      state_.x[i] = image(state_.x[i]);
      state_.v[i] = image.velocity(state_.v[i]);
      state_.S[i] = image.stress(state_.S[i]);
      rates_.dv_dt[i] = image.velocity(rates_.dv_dt[i]);
      rates_.dS_dt[i] = image.stress(rates_.dS_dt[i]);
      rates_.correction[i] = to_single(image.geometry(to_double(rates_.correction[i])));
      if (fields_.shear)
        rates_.shear_rate[i] = to_single(image.stress(to_double(rates_.shear_rate[i])));
    }
  }
}

/// Internal energy and its parts.
void Solver::heat(double duration) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < state_.size(); ++i) {
    state_.u[i] += duration * rates_.du_dt[i];
    state_.viscous_heat[i] += duration * rates_.viscous_heating[i];
    state_.shear_work[i] += duration * rates_.shear_power[i];
  }
}

void Solver::update_lists() {
  {
    const StageTimer timer(stages_, Stage::neighbours);
    if (largest_support() <= lists_.support() && !lists_.used_up(state_.x)) return;
  }
  if (++builds_in_order_ >= builds_per_order) {
    const StageTimer timer(stages_, Stage::reorder);
    reorder();
    builds_in_order_ = 0;
  }
  const StageTimer timer(stages_, Stage::neighbours);
  tree_.fit(state_.x);
  // Smoothing lengths that evolve get some room to grow before the next build.
  if (evolving_h_) {
    lists_.set_support(growth_room * largest_support());
    require_walls_apart(scene_.environment, lists_.support() * (1 + scene_.numerics.list_skin));
  }
  lists_.build(tree_, state_.x);
  ++list_builds_;
}

/// h of a particle: that of its body, or as its density says, so that its neighbours stay as many.
double Solver::smoothing_length(std::size_t i, double rho) const {
  if (!evolving_h_) return constant_h_[state_.body[i]];
  return particles::evolved_h(state_.h, materials_.lowest_density(), rho);
}

double Solver::largest_support() const {
  if (!evolving_h_) return 2 * state_.h;
  const double widest = particles::evolved_h(state_.h, materials_.lowest_density(),
                                             *std::ranges::min_element(state_.rho));
  return 2 * (sees_voids_ ? std::max(state_.h, widest) : widest);
}

void Solver::reorder() {
  const std::vector<std::uint32_t> order = tree::kd_order(state_.x, state_.id);
  visit_state(state_, [&](const char*, auto& array) { particles::permute(array, order); });
  visit_rates(rates_, [&](const char*, auto& array) { particles::permute(array, order); });
  particles::permute(pressure_, order);
  if (!is_void_.empty()) particles::permute(is_void_, order);
}

/// The stress returns to the yield surface.
void Solver::kick(double duration) {
  const StageTimer timer(stages_, Stage::integrate);
  const double age = gravity_age() + dt_;
  std::size_t offender = nobody;
  if (fields_.energy) heat(duration);
  materials_.visit_laws(state_.body, [&](const auto&, const auto& rheology) {
#pragma omp parallel for schedule(static) reduction(min : offender)
    for (std::size_t i = 0; i < state_.size(); ++i) {
      state_.v[i] += duration * (rates_.dv_dt[i] + gravity(i, age));
      state_.rho[i] = particles::changed_density(state_.rho[i], duration * rates_.drho_dt[i]);
      state_.S[i] = is_frayed(i) ? SymTensor{}
                                 : yielded(rheology[i], state_.S[i] + duration * rates_.dS_dt[i],
                                           confining_pressure(i), condition(i, 0));
      if (!is_finite(state_.v[i]) || !std::isfinite(trace(state_.S[i]) + state_.rho[i]))
        offender = std::min(offender, i);
    }
  });
  check(offender, "not-finite", "lower numerics.cfl");
}

/// The corrected gradient and its dual force stretch stresses at a free surface by the largest
/// eigenvalue of L, about two, and with them the frequency of the shortest waves there. Rubble
/// carries no stress at its surface and needs no shorter steps.
double Solver::stiffening(std::size_t i) const {
  if (!stressed_surface_ || gradient_ == Gradient::corrected_rate || gradient_ == Gradient::plain ||
      is_frayed(i))
    return 1;
  return largest_principal(to_double(rates_.correction[i]));
}

/// dt = cfl h/(L c_l + h |div v|) with the longitudinal wave c_l^2 = c^2 + 4G/(3 rho), L the
/// stiffening of surfaces that carry stress, 0.25 sqrt(h/|a|), and where stress is staggered what
/// viscosity allows; a function of state and rates alone, so a restart finds the same.
Solver::Limits Solver::time_step_limits() const {
  // Rate of signals through h, acceleration over h, rate at which viscosity damps.
  double highest = 0, strongest = 0, thickest = 0;
  const double alpha = viscosity_of(scene_).alpha;
  const double shear_modulus = materials_.target().shear_modulus;
  materials_.visit_laws(state_.body, [&](const auto& eos, const auto&) {
#pragma omp parallel for schedule(static) reduction(max : highest, strongest, thickest)
    for (std::size_t i = 0; i < state_.size(); ++i) {
      const double rho = state_.rho[i], h = smoothing_length(i, rho);
      const double c = eos[i](rho, fields_.energy ? state_.u[i] : 0.0).c;
      // Expanded damaged material carries no stress, so no wave faster than the reference.
      const double inertia = std::max(rho, reference_density(i));
      const double wave = std::sqrt(c * c + 4 * shear_modulus / (3 * inertia));
      const double divergence = std::abs(rates_.drho_dt[i]) / rho;
      highest = std::max(highest, stiffening(i) * wave / h + divergence);
      strongest = std::max(strongest, norm2(rates_.dv_dt[i]) / (h * h));
      thickest = std::max(thickest, alpha * c / h);
    }
  });
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  Limits limits{unlimited, unlimited};
  if (highest > 0) limits.motion = scene_.numerics.cfl / highest;
  if (strongest > 0)
    limits.motion = std::min(limits.motion, acceleration_safety / std::sqrt(std::sqrt(strongest)));
  if (is_staggered() && thickest > 0)
    limits.viscosity = (viscosity_lags() ? lagging_viscous_safety : viscous_safety) / thickest;
  return limits;
}

void Solver::damp(double factor, const Vec3& omega) {
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const Vec3 rotation = cross(omega, state_.x[i]);
    state_.v[i] = rotation + factor * (state_.v[i] - rotation);
  }
}

void Solver::spin_up(const Vec3& omega) {
  for (std::size_t i = 0; i < state_.size(); ++i) state_.v[i] += cross(omega, state_.x[i]);
}

}  // namespace eerie::step
