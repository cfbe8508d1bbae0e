#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/scene/tide.hpp"
#include "solver/step/solver.hpp"

// Gravity once in a cycle of steps.

namespace eerie::step {

namespace {

constexpr long steps_without_gravity = 10;
/// Part of a whole cycle from which on the change of gravity says something about its rate.
constexpr double shortest_telling_cycle = 0.3;

}  // namespace

bool Solver::knows_gravity_rate() const {
  return std::ranges::any_of(rates_.dg_dt, [](const Vec3f& r) { return r != Vec3f{}; });
}

/// Steps between evaluations of gravity, so that its linear extrapolation over t errs by
/// (t/T)^2/2 = gravity_tolerance. T, the time in which the field changes, is the shorter one of
/// the dynamical time (G rho0)^-1/2 and of the time in which particles cross the radius of a body
/// of the whole mass.
/// Without self-gravity cycles are short, so that dt keeps up with laboratory scenes.
long Solver::steps_in_cycle() const {
  const long interval = scene_.numerics.gravity_interval;
  if (!scene_.environment.self_gravity) return std::min(interval, steps_without_gravity);
  double v2 = 0;
  for (const Vec3& v : state_.v) v2 += norm2(v);
  const double n = static_cast<double>(state_.size());
  const double rho0 = materials_.highest_density();
  const double radius = std::cbrt(3 * n * state_.mass / (4 * pi * rho0));
  const double change = std::max(std::sqrt(newton_G * rho0), std::sqrt(v2 / n) / radius);
  // After a start its rate is not known yet: g is constant, which errs by t/T. Other integrators
  // keep the bits of what was computed with them.
  const bool is_linear = !is_staggered() || knows_gravity_rate();
  const double tolerance = scene_.numerics.gravity_tolerance,
               reach = is_linear ? std::sqrt(2 * tolerance) : tolerance;
  const double steps = reach / (change * dt_);
  return static_cast<long>(std::clamp(steps, 1.0, static_cast<double>(interval)));
}

/// Gravity anew, and its rate from the evaluation `elapsed` seconds ago (0: there was none).
/// Between evaluations it goes on linearly. Holding it constant would twist every spinning body;
/// kicking it in lumps would shake a resting one, so that viscosity, not friction, carries it.
/// A cycle that an end time has cut short keeps the old rate: over a moment g changes by less than
/// its rounding, which a whole cycle would magnify.
void Solver::evaluate_gravity(double elapsed, double planned) {
  const StageTimer timer(stages_, Stage::gravity);
  const auto [gx, gy, gz] = scene_.environment.gravity_m_per_s2;
  const Vec3 uniform{gx, gy, gz};
  if (!scene_.environment.self_gravity) {
    std::fill(rates_.g.begin(), rates_.g.end(), Vec3f(uniform));
    return;
  }
  const Tide tide(scene_.environment.primary);
  const Vec3 primary = tide.place(state_.time);
  // The mean rate of the cycle behind lags by half of it. What it changed by makes up for most of
  // that; all of it would let errors go on from cycle to cycle.
  const double lead = is_staggered() && knows_gravity_rate() ? 0.5 : 0;
  tree_.fit(state_.x);
  const bool tells_rate = elapsed > shortest_telling_cycle * planned;
  const auto store = [&](std::size_t i, const Vec3& attraction) {
    const Vec3 before = rates_.g[i];
    rates_.g[i] = Vec3f(attraction + uniform + tide.acceleration(state_.x[i], primary));
    if (!tells_rate) return;
    const Vec3 rate = (Vec3(rates_.g[i]) - before) / elapsed, last = Vec3(rates_.dg_dt[i]);
    rates_.dg_dt[i] = Vec3f(rate + lead * (rate - last));
  };
  // Known after all particles have been asked; taken off in place, which needs no memory.
  const RigidField net = gravity_.accelerations(tree_, state_.x, store);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const Vec3 excess = net.at(state_.x[i]);
    rates_.g[i] = Vec3f(Vec3(rates_.g[i]) - excess);
    if (tells_rate)
      rates_.dg_dt[i] = Vec3f(Vec3(rates_.dg_dt[i]) - ((1 + lead) / elapsed) * excess);
  }
}

}  // namespace eerie::step
