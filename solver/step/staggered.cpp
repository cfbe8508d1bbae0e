#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/packs.hpp"
#include "solver/sph/stress.hpp"
#include "solver/step/solver.hpp"

// The moves of an integrator that staggers stress against velocity (integrators/staggered.hpp).

namespace eerie::step {

namespace {

/// exp(-strain) to second order, positive for any strain: what a density is multiplied by.
DoublePack thinned(const DoublePack& strain) {
  const DoublePack none{}, one = none + 1;
  const DoublePack stretch = strain > none ? strain : none,
                   squeeze = strain < none ? -strain : none;
  const auto series = [&](const DoublePack& x) { return DoublePack(one + x + 0.5 * x * x); };
  return series(squeeze) / series(stretch);
}

Vec3 brake(const sph::PackedSums& s, std::size_t l) {
  return {s.brake[0][l], s.brake[1][l], s.brake[2][l]};
}

SymTensor lane(const SymTensorOf<DoublePack>& s, std::size_t l) {
  return {s.xx[l], s.yy[l], s.zz[l], s.xy[l], s.xz[l], s.yz[l]};
}

}  // namespace

void step::Solver::push_and_drift(double push, double drift) {
  {
    const StageTimer timer(stages_, Stage::integrate);
    const double age = gravity_age();
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < state_.size(); ++i) {
      state_.v[i] += push * (rates_.dv_dt[i] + gravity(i, age));
      state_.x[i] += drift * state_.v[i];
    }
    if (fields_.energy) heat_by_viscosity(push);
    if (!walls_.empty()) turn_back(drift);
  }
  update_lists();
}

void step::Solver::push(double duration) {
  const StageTimer timer(stages_, Stage::integrate);
  const double age = gravity_age() + dt_;
  std::size_t offender = nobody;
#pragma omp parallel for schedule(static) reduction(min : offender)
  for (std::size_t i = 0; i < state_.size(); ++i) {
    state_.v[i] += duration * (rates_.dv_dt[i] + gravity(i, age));
    if (!is_finite(state_.v[i]) || !std::isfinite(trace(state_.S[i]) + state_.rho[i]))
      offender = std::min(offender, i);
  }
  if (fields_.energy) heat_by_viscosity(duration);
  check(offender, "not-finite", "lower numerics.cfl");
}

/// The heat of viscosity goes with the forces that it belongs to.
void step::Solver::heat_by_viscosity(double duration) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < state_.size(); ++i) {
    state_.u[i] += duration * rates_.viscous_heating[i];
    state_.viscous_heat[i] += duration * rates_.viscous_heating[i];
  }
}

/// Density, stress and the work on them by the velocity gradient in the middle of the step, where
/// positions were half of its drift ago. The stress is a trial until the next forces.
void step::Solver::deform(double duration) {
  set_middle_rows(duration);
  const StageTimer timer(stages_, Stage::pairs);
  std::size_t singular = nobody;
  visit_sums([&](auto& sums) {
    sums.template sweep<sph::Part::gradient>(
        lists_, state_.size(), [&](std::size_t i, std::size_t count, const auto& s) {
          if (const std::size_t found = go_on(i, count, duration, s); found != nobody) {
#pragma omp critical
            singular = std::min(singular, found);
          }
        });
  });
  check_collapse(singular);
}

void step::Solver::set_middle_rows(double duration) {
  const StageTimer timer(stages_, Stage::material);
  visit_sums([&](auto& sums) {
#pragma omp parallel for schedule(static)
    for (std::size_t b = 0; b < tree::bucket_count(state_.size()); ++b) {
      const std::size_t first = b * tree::bucket_size,
                        last = std::min(first + tree::bucket_size, state_.size());
      const auto middle = [&](std::size_t i) { return state_.x[i] - (duration / 2) * state_.v[i]; };
      sums.rows.set_origin(b, middle(first), state_.v[first]);
      for (std::size_t i = first; i < last; ++i) {
        const double rho = predicted_density(i, duration / 2);
        sums.rows.set_motion(i, middle(i), state_.v[i], state_.mass / filling_density(rho));
        if constexpr (std::remove_cvref_t<decltype(sums)>::extended)
          sums.rows.set_extra(i, {}, smoothing_length(i, rho));
      }
    }
  });
}

/// `count` particles from i on; several at once, as everything here is arithmetic. Returns the
/// first whose neighbourhood has collapsed, or nobody.
std::size_t step::Solver::go_on(std::size_t i, std::size_t count, double duration,
                                const sph::PackedSums& s) {
  using P = DoublePack;
  const P rho = gathered(count, [&](std::size_t l) { return state_.rho[i + l]; });
  const SymTensorOf<P> S = gathered_tensors(count, &state_.S[i]);
  SymTensorOf<P> L{P{} + 1, P{} + 1, P{} + 1, P{}, P{}, P{}};
  std::size_t collapsed = nobody;
  if (gradient_ != Gradient::plain) {
    L = sph::correction_matrix(s.C);
    collapsed = first_collapsed(i, count, s, rho);
  }
  std::array<SymTensorf, lanes<double>> before;  // what the forces at hand are made of
  std::copy_n(&rates_.correction[i], count, before.begin());
  scatter_tensors(count, L, &rates_.correction[i]);
  const Mat3Of<P> gradient = s.G * to_matrix(L);
  const P divergence = gradient_ == Gradient::corrected_fully
                           ? trace(s.G * to_matrix(sph::moderate(L)))
                           : trace(s.G);
  // By the midpoint rule, as stress turns with its own rate.
  const P half = splat(duration / 2), whole = splat(duration);
  const SymTensorOf<P> middle =
      S + half * sph::stress_rate(S, gradient, materials_.target().shear_modulus);
  const SymTensorOf<P> trial =
      S + whole * sph::stress_rate(middle, gradient, materials_.target().shear_modulus);
  const P after = rho * thinned(P(whole * divergence));
  if (fields_.energy)
    for (std::size_t l = 0; l < count; ++l)
      heat_by_strain(i + l, duration, {lane(s, l).G, before[l], lane(trial, l), after[l]});
  if (fields_.shear)
    scatter_tensors(count, sph::deviatoric_strain(gradient), &rates_.shear_rate[i]);
  scatter_tensors(count, trial, &state_.S[i]);
  scatter(count, P(-rho * divergence),
          [&](std::size_t l, double rate) { rates_.drho_dt[i + l] = rate; });
  scatter(count, after, [&](std::size_t l, double value) { state_.rho[i + l] = value; });
  return collapsed;
}

/// The work of the stresses that push at both ends of the step, each with the correction that its
/// force has, half of it each: what is lost to friction within the step is never done.
void step::Solver::heat_by_strain(std::size_t i, double duration, const Strained& now) {
  const auto shear_power = [&](const SymTensor& S, const SymTensor& L) {
    const bool dual = gradient_ == Gradient::corrected || gradient_ == Gradient::corrected_fully;
    const Mat3 g = dual ? now.G * to_matrix(L) : now.G;
    return S.xx * g[0][0] + S.yy * g[1][1] + S.zz * g[2][2] + S.xy * (g[0][1] + g[1][0]) +
           S.xz * (g[0][2] + g[2][0]) + S.yz * (g[1][2] + g[2][1]);
  };
  const auto dilation = [&](const SymTensor& L) {
    return gradient_ == Gradient::corrected_fully ? trace(now.G * to_matrix(sph::moderate(L)))
                                                  : trace(now.G);
  };
  const SymTensor L_before = to_double(now.L_before), L_after = to_double(rates_.correction[i]);
  const double share = duration / 2 / filling_density(predicted_density(i, duration / 2));
  const double shear = shear_power(state_.S[i], L_before),
               press = -pressure_[i] * dilation(L_before);
  materials_.visit_laws(state_.body, [&](const auto& eos, const auto& rheology) {
    material::Condition then = condition(i, 0);
    then.u += 2 * share * (shear + press);
    double p = rheology[i].pressure(eos[i](now.rho_after, then.u).p, then);
    if (is_void(i)) p = std::min(p, 0.0);
    const double shear_after = shear_power(yielded(rheology[i], now.trial, p, then), L_after);
    state_.shear_work[i] += share * (shear + shear_after);
    state_.u[i] += share * (shear + shear_after + press - p * dilation(L_after));
  });
}

/// Where matter is softer and viscosity keeps its size, viscosity is what would shorten steps.
/// With velocities of the half step it may damp twice as fast; it is of first order then.
bool step::Solver::viscosity_lags() const {
  return state_.softening.sound_speed < 1 && !state_.softening.is_calm;
}

/// Those with which a simulated second costs least, of as many as the scene allows.
ChebyshevStages step::Solver::cheapest_stages(const Limits& limits) const {
  constexpr double visit = 0.25;  // one for viscosity alone, in steps
  ChebyshevStages cheapest;
  if (!viscosity_lags()) return cheapest;
  double least = 1 / limits.with(cheapest);
  for (int count = 2; count <= scene_.numerics.viscous_stages; ++count) {
    const ChebyshevStages stages(count);
    const double cost = (1 + visit * (count - 1)) / limits.with(stages);
    if (cost < least) least = cost, cheapest = stages;
  }
  return cheapest;
}

/// The fewest that are stable at the dt of this cycle.
void step::Solver::take_stages(const Limits& limits) {
  constexpr double rounding = 1e-9;
  int count = 1;
  while (dt_ > (1 + rounding) * ChebyshevStages(count).reach() * limits.viscosity) ++count;
  stages_of_viscosity_ = ChebyshevStages(count);
  const bool several = stages_of_viscosity_.count() > 1;
  for (std::vector<Vec3>* one : {&change_, &change_before_})
    one->resize(several ? state_.size() : 0);
}

/// Forces of the stress, once it has returned to the yield surface of its new pressure.
void step::Solver::exert(double ahead) {
  apply_material({.velocity = viscosity_lags() ? 0 : ahead, .stress = 0, .is_final = true});
  const StageTimer timer(stages_, Stage::pairs);
  sum_forces(ahead);
  if (stages_of_viscosity_.count() > 1) damp_in_stages();
}

void step::Solver::sum_forces(double ahead) {
  visit_sums([&](auto& sums) {
    sums.template sweep<sph::Part::force>(
        lists_, state_.size(), [&](std::size_t i, std::size_t count, const auto& s) {
          std::array<Vec3, lanes<double>> before;
          std::copy_n(&rates_.dv_dt[i], count, before.begin());
          set_forces(i, count, s);
          for (std::size_t l = 0; !change_.empty() && l < count; ++l) begin_stages(i + l, s, l);
          if constexpr (std::remove_cvref_t<decltype(sums)>::extended)
            if (fields_.energy)
              for (std::size_t l = 0; l < count; ++l)
                heat_by_brake(i + l, ahead * (rates_.dv_dt[i + l] - before[l]), s, l);
        });
  });
}

/// The first stage of viscosity. What is left of the acceleration stays in all of them.
void step::Solver::begin_stages(std::size_t i, const sph::PackedSums& s, std::size_t l) {
  change_[i] = (stages_of_viscosity_.first() * dt_) * rates_.dv_dt[i];
  change_before_[i] = {};
  rates_.dv_dt[i] -= acceleration_by_viscosity(i, s, l);
}

/// Viscosity damps in several stages what one would not, at the positions of the first, while all
/// other forces stay. The mean acceleration of the step is what pushes.
void step::Solver::damp_in_stages() {
  const ChebyshevStages& stages = stages_of_viscosity_;
  const std::size_t n = state_.size();
  for (int stage = 2; stage <= stages.count(); ++stage) {
    const ChebyshevStages::Weights weight = stages.weights(stage);
    visit_sums([&](auto& sums) {
#pragma omp parallel for schedule(static)
      for (std::size_t i = 0; i < n; ++i) sums.rows.set_velocity(i, state_.v[i] + change_[i]);
      sums.template sweep<sph::Part::viscous>(
          lists_, n, [&](std::size_t i, std::size_t count, const auto& s) {
            for (std::size_t l = 0, k = i; l < count; ++l, ++k) {
              const Vec3 rate = rates_.dv_dt[k] + acceleration_by_viscosity(k, s, l);
              change_before_[k] = weight.last * change_[k] + weight.before * change_before_[k] +
                                  (weight.step * dt_) * rate;
            }
          });
    });
    std::swap(change_, change_before_);
  }
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) rates_.dv_dt[i] = change_[i] / dt_;
}

/// What viscosity takes from motion is heat: its sums are over predicted velocities, and `change`
/// is what the forces that are new make of them.
void step::Solver::heat_by_brake(std::size_t i, const Vec3& change, const sph::PackedSums& s,
                                 std::size_t l) {
  rates_.viscous_heating[i] =
      (s.heat[l] - dot(brake(s, l), change)) / filling_density(state_.rho[i]);
}

Vec3 step::Solver::acceleration_by_viscosity(std::size_t i, const sph::PackedSums& s,
                                             std::size_t l) const {
  return brake(s, l) / filling_density(state_.rho[i]);
}

void step::Solver::set_forces(std::size_t i, std::size_t count, const sph::PackedSums& s) {
  using P = DoublePack;
  const P per_rho =
      1 / gathered(count, [&](std::size_t l) { return filling_density(state_.rho[i + l]); });
  for (int a = 0; a < 3; ++a)
    scatter(count, P(s.force[static_cast<std::size_t>(a)] * per_rho),
            [&](std::size_t l, double rate) { rates_.dv_dt[i + l][a] = rate; });
  if (fields_.viscous_pressure)
    scatter(count, s.viscous_pressure, [&](std::size_t l, double p) {
      rates_.viscous_pressure[i + l] = static_cast<float>(p);
    });
}

}  // namespace eerie::step
