#include "tests/proof/tension.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"

namespace eerie::proof {

namespace {

constexpr double rho0 = 2700, K = 2.67e10, G = 2.27e10, E = 9 * K * G / (3 * K + G);
constexpr double weibull_k = 4e35, m = 9, crack_speed = 0.4;
constexpr double steps_to_peak = 200;  // before which every run ends or is well past its peak

double wave() { return std::sqrt((K + 4 * G / 3) / rho0); }
/// Strain that opens flaws, sigma/E, per second.
double opening_rate(double rate) { return 3 * K * rate / E; }
double damage_at_peak() { return 1 / (m + 4); }

double continuum_peak_time(double rate) {
  const double growth = crack_speed * wave() * std::cbrt(4 * pi / 3 * weibull_k) *
                        std::pow(opening_rate(rate), m / 3) / (m / 3 + 1);
  return std::pow(std::cbrt(damage_at_peak()) / growth, 1 / (m / 3 + 1));
}

Scene scene_of(const Pull& p) {
  const double dt = continuum_peak_time(p.rate) / steps_to_peak, h = 1.2 * p.spacing;
  return lab_scene(
      {{"environment", {{"walls", {wall("x_low", 0), wall("y_low", 0), wall("z_low", 0)}}}},
       {"material",
        {{"rho0_kg_per_m3", rho0},
         {"eos", "linear"},
         {"linear", {{"bulk_modulus_Pa", K}}},
         {"shear_modulus_Pa", G},
         {"rheology", "lundborg"},
         {"lundborg", {{"Y_0_Pa", 1e9}}},  // so that it breaks and does not flow
         {"fracture", "grady-kipp"},
         {"grady_kipp", {{"k_per_m3", weibull_k}, {"m", m}, {"crack_speed", crack_speed}}}}},
       {"numerics", {{"cfl", std::min(0.4, dt * wave() / h)}, {"gravity_interval", 1}}}});
}

}  // namespace

double peak_of_continuum(double rate) {
  return E * opening_rate(rate) * continuum_peak_time(rate) * (1 - damage_at_peak());
}

double matching_spacing(double rate) {
  const double strain = opening_rate(rate) * continuum_peak_time(rate);
  return std::cbrt(3 / (weibull_k * std::pow(strain, m)));
}

double weakest_flaw(double spacing, double particles) {
  return E * std::pow(weibull_k * particles * spacing * spacing * spacing, -1 / m);
}

Strength pull(const Pull& p) {
  const double side = p.across * p.spacing;
  particles::State state = lattice_block({0, 0, 0}, {side, side, side}, p.spacing, rho0);
  // Four particles from the free faces on, inwards.
  const double middle = side - 4 * p.spacing;
  std::vector<bool> inside;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Vec3& x = state.x[i];
    inside.push_back(std::max({x.x, x.y, x.z}) < middle);
    state.v[i] = p.rate * x;
  }
  const auto counted = static_cast<double>(std::count(inside.begin(), inside.end(), true));
  step::Solver solver(scene_of(p), std::move(state));
  Strength strength{};
  // Past the peak the tension falls by half at once; then the run is over.
  for (double tension = 0; tension > 0.7 * strength.peak || strength.peak == 0;) {
    solver.cycle(1e9);
    tension = 0;
    const particles::State& s = solver.state();
    for (std::size_t i = 0; i < s.size(); ++i)
      if (inside[s.id[i]]) tension -= solver.pressure()[i] / counted;
    if (tension <= strength.peak) continue;
    const double strain = opening_rate(p.rate) * s.time;
    strength = {tension, weibull_k * std::pow(p.spacing, 3) * std::pow(strain, m),
                wave() * s.time / p.spacing};
  }
  return strength;
}

double peak_without_inertia(const Pull& p) {
  const Scene scene = scene_of(p);
  const material::GradyKipp law(scene.material);
  const std::size_t n = static_cast<std::size_t>(p.across) * static_cast<std::size_t>(p.across) *
                        static_cast<std::size_t>(p.across);
  const double volume = p.spacing * p.spacing * p.spacing;
  Random random(7, 1);
  const material::Flaws flaws = law.deal(n, volume * static_cast<double>(n), random);
  const double R_s = std::cbrt(3 * volume / (4 * pi));
  const double dt = continuum_peak_time(p.rate) / steps_to_peak;
  std::vector<double> damage_cbrt(n, 0.0);
  double peak = 0;
  for (double t = dt, tension = 0; tension > 0.7 * peak || peak == 0; t += dt) {
    const double strain = opening_rate(p.rate) * t;
    double whole = 0;
    for (std::size_t id = 0; id < n; ++id) {
      damage_cbrt[id] = law.grown(damage_cbrt[id], strain, flaws[id], wave(), R_s, dt);
      whole += 1 - std::pow(damage_cbrt[id], 3);
    }
    tension = E * strain * whole / static_cast<double>(n);
    peak = std::max(peak, tension);
  }
  return peak;
}

}  // namespace eerie::proof
