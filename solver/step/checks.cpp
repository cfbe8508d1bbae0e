#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/step/solver.hpp"

// What stops a Solver: states that no sound run reaches.

namespace eerie::step {

/// Speeds that no sound impact exceeds: ten times what the bodies bring and fall with, and, where
/// stresses alone move them, their waves.
void Solver::expect_speeds() {
  double fastest = 0;
  for (std::size_t i = 0; i < state_.size(); ++i) {
    reach_ = std::max(reach_, norm(state_.x[i]));
    fastest = std::max(fastest, norm(state_.v[i]));
  }
  reach_ = 2 * reach_ + 10 * state_.h;
  begun_ = state_.time;
  const double mass = state_.mass * static_cast<double>(state_.size());
  const double rho0 = materials_.highest_density();
  const double radius = std::cbrt(3 * mass / (4 * pi * rho0));
  if (scene_.environment.self_gravity) fastest += escape_speed({radius, rho0});
  fastest_expected_ = 10 * fastest;
  if (fields_.energy || !scene_.environment.self_gravity) {
    double c = 0;
    materials_.visit_laws(state_.body, [&](const auto& eos, const auto&) {
      for (std::size_t i = 0; i < state_.size(); ++i)
        c = std::max(c, eos[i](state_.rho[i], fields_.energy ? state_.u[i] : 0.0).c);
    });
    fastest_expected_ += 10 * (c + materials_.fastest_wave());
  }
}

/// Nothing outside walls, nothing lost to infinity; counts the particles left uncorrected.
void Solver::check_positions() {
  const auto [gx, gy, gz] = scene_.environment.gravity_m_per_s2;
  const double t = state_.time - begun_, fall = 0.5 * norm(Vec3{gx, gy, gz}) * t * t;
  const double reach = reach_ + fastest_expected_ * t + fall;
  std::size_t lost = nobody, through = nobody;
  long alone = 0;
#pragma omp parallel for schedule(static) reduction(min : lost, through) reduction(+ : alone)
  for (std::size_t i = 0; i < state_.size(); ++i) {
    if (!(norm2(state_.x[i]) < reach * reach)) lost = std::min(lost, i);
    for (const tree::Mirror& wall : walls_)
      if ((state_.x[i][wall.axis] < wall.at) == wall.low) through = std::min(through, i);
    alone += rates_.correction[i] == SymTensorf{1, 1, 1, 0, 0, 0};
  }
  uncorrected_ = alone;
  check(lost, "lost-particle",
        "it is further away than its bodies can have thrown it; lower numerics.cfl");
  check(through, "through-wall", "lower numerics.cfl or raise numerics.viscosity_beta");
}

void Solver::check(std::size_t offender, const char* kind, const char* remedy) const {
  if (offender == nobody) return;
  const auto id = static_cast<long>(state_.id[offender]);
  const Vec3& x = state_.x[offender];
  throw NumericalError(
      kind, state_.step, id,
      fmt::format("{} at step {} (t = {:.6g} s), particle {} at ({:.6g}, {:.6g}, {:.6g}) m: rho = "
                  "{:.4g} kg/m^3, |v| = {:.4g} m/s; {} (cfl is {:g})",
                  kind, state_.step, state_.time, id, x.x, x.y, x.z, state_.rho[offender],
                  norm(state_.v[offender]), remedy, scene_.numerics.cfl));
}

}  // namespace eerie::step
