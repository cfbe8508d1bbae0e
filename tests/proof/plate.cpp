#include "tests/proof/plate.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"

namespace eerie::proof {

namespace {

constexpr double L = 0.2, H = 0.02, E = 2e6, rho0 = 1000, nu = 0.3975;
constexpr double first_speed = 1e-6;  // m/s; small, so that the laws are linear
constexpr double K = E / (3 * (1 - 2 * nu)), G = E / (2 * (1 + nu));

double wave_number(Support support) {
  return (support == Support::clamped ? 1.8751040687 : 4.7300407449) / L;
}

/// Deflection of the gravest mode; x from the clamped end or from the middle.
double shape(Support support, double x) {
  const double k = wave_number(support), kx = k * x;
  if (support == Support::free)
    return std::cos(kx) + std::cos(k * L / 2) / std::cosh(k * L / 2) * std::cosh(kx);
  const double share = (std::cosh(k * L) + std::cos(k * L)) / (std::sinh(k * L) + std::sin(k * L));
  return std::cosh(kx) - std::cos(kx) - share * (std::sinh(kx) - std::sin(kx));
}

}  // namespace

double thin_plate_period(Support support) {
  const double k = wave_number(support);
  return 2 * pi / (k * k * H) * std::sqrt(12 * rho0 * (1 - nu * nu) / E);
}

// Rayleigh's quotient with the thin plate's mode W: rotary inertia adds (H^2/24) R to the period,
// R = int W'^2/int W^2, and shear (H^2/24) E'/(5 G/6) S, S = int W'''^2/int W''^2.
double thickness_correction(Support support) {
  const bool clamped = support == Support::clamped;
  const double R = clamped ? 4.648 : 49.48, S = clamped ? 4.648 : 12.30;
  return H * H / (L * L) / 24 * (R + E / (1 - nu * nu) / (5 * G / 6) * S);
}

Oscillation plate_oscillation(Support support, int layers, double artificial_stress) {
  const double d = H / layers, depth = 3 * d;
  const bool clamped = support == Support::clamped;
  const Scene scene = lab_scene(
      {{"environment",
        {{"walls",
          {wall("x_low", 0, clamped ? "rough" : "slip"), wall("z_low", 0),
           wall("z_high", depth)}}}},
       {"material", elastic_material(rho0, K, G)},
       {"numerics",
        {{"artificial_stress", artificial_stress}, {"precision", "double"}, {"cfl", 0.8}}}});
  particles::State state =
      lattice_block({0, -H / 2, 0}, {clamped ? L : L / 2, H / 2, depth}, d, rho0);
  const std::vector<Vec3> start = state.x;
  std::vector<double> mode;
  for (std::size_t i = 0; i < state.size(); ++i) {
    mode.push_back(shape(support, state.x[i].x));
    state.v[i].y = first_speed * mode.back();
  }
  step::Solver solver(scene, std::move(state));
  const particles::State& now = solver.state();
  const auto amplitude = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < now.size(); ++i) sum += now.v[i].y * mode[now.id[i]];
    return sum;
  };
  const std::vector<double> crossings =
      zero_crossings(solver, amplitude, 2, 2 * thin_plate_period(support));
  Oscillation seen{crossings.size() == 2 ? 2 * (crossings[1] - crossings[0]) : 0, 0};
  for (std::size_t i = 0; i < now.size(); ++i)
    seen.z_drift = std::max(seen.z_drift, std::abs(now.x[i].z - start[now.id[i]].z) / d);
  return seen;
}

}  // namespace eerie::proof
