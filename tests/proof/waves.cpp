#include "tests/proof/waves.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/base/constants.hpp"
#include "solver/sph/kernel.hpp"
#include "solver/step/solver.hpp"
#include "solver/step/totals.hpp"
#include "tests/proof/lab.hpp"

namespace eerie::proof {

namespace {

double sound(const Gas& gas, double gamma) { return std::sqrt(gamma * gas.p / gas.rho); }

/// Change of velocity across the wave from `gas` to the pressure p: shock or rarefaction.
double velocity_change(const Gas& gas, double gamma, double p) {
  if (p > gas.p) {
    const double A = 2 / ((gamma + 1) * gas.rho), B = (gamma - 1) / (gamma + 1) * gas.p;
    return (p - gas.p) * std::sqrt(A / (p + B));
  }
  return 2 * sound(gas, gamma) / (gamma - 1) * (std::pow(p / gas.p, (gamma - 1) / (2 * gamma)) - 1);
}

/// State at `speed` on the side of `gas` on the left; p, v: of the middle.
Gas left_of_contact(const Gas& gas, double gamma, double p, double v, double speed) {
  const double c = sound(gas, gamma), ratio = p / gas.p, f = (gamma - 1) / (gamma + 1);
  if (p > gas.p) {
    const double front =
        gas.v - c * std::sqrt((gamma + 1) / (2 * gamma) * ratio + (gamma - 1) / (2 * gamma));
    return speed < front ? gas : Gas{gas.rho * (ratio + f) / (f * ratio + 1), v, p};
  }
  const double behind = c * std::pow(ratio, (gamma - 1) / (2 * gamma));
  if (speed < gas.v - c) return gas;
  if (speed > v - behind) return {gas.rho * std::pow(ratio, 1 / gamma), v, p};
  const double here = 2 / (gamma + 1) * (c + (gamma - 1) / 2 * (gas.v - speed)), share = here / c;
  return {gas.rho * std::pow(share, 2 / (gamma - 1)),
          2 / (gamma + 1) * (c + (gamma - 1) / 2 * gas.v + speed),
          gas.p * std::pow(share, 2 * gamma / (gamma - 1))};
}

// The elastic material of standing waves and their box.
constexpr double rho0 = 1000, K = 3e6, G = 1e6, side = 1, h_over_spacing = 1.2;

nlohmann::json box_walls(const Vec3& lo, const Vec3& hi) {
  return {wall("x_low", lo.x),  wall("x_high", hi.x), wall("y_low", lo.y),
          wall("y_high", hi.y), wall("z_low", lo.z),  wall("z_high", hi.z)};
}

}  // namespace

Gas riemann(const Gas& left, const Gas& right, double gamma, double speed) {
  // The pressure between the waves, by bisection: the velocity change rises with it.
  double lo = 0, hi = 10 * std::max(left.p, right.p);
  const auto excess = [&](double p) {
    return velocity_change(left, gamma, p) + velocity_change(right, gamma, p) + right.v - left.v;
  };
  for (int k = 0; k < 200; ++k) (excess((lo + hi) / 2) > 0 ? hi : lo) = (lo + hi) / 2;
  const double p = (lo + hi) / 2, v = left.v - velocity_change(left, gamma, p);
  if (speed <= v) return left_of_contact(left, gamma, p, v, speed);
  const Gas mirrored = left_of_contact({right.rho, -right.v, right.p}, gamma, p, -v, -speed);
  return {mirrored.rho, -mirrored.v, mirrored.p};
}

Sod sod_tube(int half, double h_over_spacing) {
  const double d = Sod::length / 2 / half, width = 8 * d, end = Sod::length / 2;
  particles::State state = lattice_block({-end, 0, 0}, {0, width, width}, d, Sod::left.rho);
  const particles::State thin =
      lattice_block({0, 0, 0}, {end, width, width}, 2 * d, Sod::right.rho, {}, h_over_spacing);
  state.h = thin.h;  // at the reference density, that of the thin gas
  state.x.insert(state.x.end(), thin.x.begin(), thin.x.end());
  state.rho.insert(state.rho.end(), thin.rho.begin(), thin.rho.end());
  particles::resize(state, state.x.size(), {.energy = true});
  std::iota(state.id.begin(), state.id.end(), 0u);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Gas& gas = state.x[i].x < 0 ? Sod::left : Sod::right;
    state.u[i] = gas.p / ((Sod::gamma - 1) * gas.rho);
  }
  const Scene scene =
      lab_scene({{"environment", {{"walls", box_walls({-end, 0, 0}, {end, width, width})}}},
                 {"material",
                  {{"rho0_kg_per_m3", Sod::right.rho},
                   {"eos", "ideal-gas"},
                   {"energy", "integrated"},
                   {"rheology", "fluid"}}},
                 {"numerics", {{"smoothing", "evolving"}, {"gravity_interval", 1}}}});
  const auto energy = [&](const particles::State& s) {
    const step::Totals t = step::totals(scene, s);
    return t.kinetic_energy + t.internal_energy;
  };
  const double before = energy(state);
  step::Solver solver(scene, std::move(state));
  while (solver.state().time < Sod::time) solver.cycle(Sod::time);

  const particles::State& s = solver.state();
  std::vector<std::size_t> order(s.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return s.x[a].x < s.x[b].x; });
  Sod sod{};
  double volume = 0;
  const double fastest = riemann(Sod::left, Sod::right, Sod::gamma, 0).v;
  for (const std::size_t i : order) {
    const double rho = s.rho[i], p = (Sod::gamma - 1) * rho * s.u[i], V = s.mass / rho;
    const Gas exact = riemann(Sod::left, Sod::right, Sod::gamma, s.x[i].x / s.time);
    sod.error_rho += V * std::abs(rho - exact.rho) / Sod::left.rho;
    sod.error_v += V * std::abs(s.v[i].x - exact.v) / fastest;
    sod.error_p += V * std::abs(p - exact.p) / Sod::left.p;
    volume += V;
    sod.x.push_back(s.x[i].x), sod.rho.push_back(rho);
    sod.v.push_back(s.v[i].x), sod.p.push_back(p);
  }
  sod.error_rho /= volume, sod.error_v /= volume, sod.error_p /= volume;
  sod.energy_drift = energy(s) / before - 1;
  return sod;
}

double wave_speed_ratio(Wave wave, int across) {
  const double d = side / across, depth = 3 * d;
  const bool shear = wave == Wave::shear;
  const Vec3 size{side, shear ? side : depth, depth};
  const Scene scene = lab_scene({{"environment", {{"walls", box_walls({0, 0, 0}, size)}}},
                                 {"material", elastic_material(rho0, K, G)},
                                 {"numerics",
                                  {{"viscosity_alpha", 0.05},
                                   {"viscosity_beta", 0},
                                   {"cfl", 0.2},
                                   {"gravity_interval", 1}}}});
  particles::State state = lattice_block({0, 0, 0}, size, d, rho0, {}, h_over_spacing);
  const double k = pi / side;
  const double theory = shear ? std::sqrt(G / rho0) : std::sqrt((K + 4 * G / 3) / rho0);
  const double frequency = theory * k * (shear ? std::sqrt(2.) : 1);
  std::vector<Vec3> mode(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3& x = state.x[i];
    mode[i] = shear ? Vec3{std::sin(k * x.x) * std::cos(k * x.y),
                           -std::cos(k * x.x) * std::sin(k * x.y), 0}
                    : Vec3{std::sin(k * x.x), 0, 0};
    state.v[i] = 1e-4 * theory * mode[i];
  }
  step::Solver solver(scene, std::move(state));
  const auto amplitude = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < solver.state().size(); ++i)
      sum += dot(solver.state().v[i], mode[solver.state().id[i]]);
    return sum;
  };
  const std::vector<double> crossings = zero_crossings(solver, amplitude, 2, 4 * pi / frequency);
  if (crossings.size() < 2) return 0;                     // it never swung back
  return pi / (crossings[1] - crossings[0]) / frequency;  // half a period apart
}

double expected_speed_ratio(Wave wave, int across) {
  const double h = h_over_spacing;  // in spacings
  double C = 0;
  for (int a = -3; a <= 3; ++a)
    for (int b = -3; b <= 3; ++b)
      for (int c = -3; c <= 3; ++c) {
        const double r = std::sqrt(a * a + b * b + c * c);
        if (r > 0)
          C -= sph::CubicSpline::normalisation / std::pow(h, 5) *
               sph::CubicSpline::dw_over_q(r / h, h / r) * a * a;
      }
  const bool shear = wave == Wave::shear;
  const double kh = pi * h / across * (shear ? std::sqrt(2.) : 1);
  // With "corrected-fully" the gradient of the pressure is exact, too.
  if (lab_scene(nlohmann::json::object()).numerics.gradient == "corrected-fully") C = 1;
  const double lattice = std::sqrt((K * C * C + 4 * G / 3) / (K + 4 * G / 3));
  return (shear ? 1 : lattice) * (1 - 0.15 * kh * kh);
}

}  // namespace eerie::proof
