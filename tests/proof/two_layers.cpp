#include "tests/proof/two_layers.hpp"

#include <cmath>
#include <numeric>

#include "solver/base/constants.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"

namespace eerie::proof {

namespace {

/// Both layers along x, which meet at x = 0, between walls; target particles are the dense ones.
particles::State two_layers(double low, double high, double dense_spacing, double width) {
  particles::State all =
      lattice_block({low, 0, 0}, {0, width, width}, dense_spacing, dense_density);
  const particles::State light =
      lattice_block({0, 0, 0}, {high, width, width}, 1.5 * dense_spacing, light_density);
  all.h = light.h;  // at the lower one of the densities
  const std::size_t dense = all.size();
  particles::resize(all, dense + light.size());
  for (std::size_t i = 0; i < light.size(); ++i) {
    all.x[dense + i] = light.x[i];
    all.rho[dense + i] = light.rho[i];
    all.body[dense + i] = static_cast<std::uint8_t>(particles::Body::impactor);
  }
  std::iota(all.id.begin(), all.id.end(), 0u);
  return all;
}

Scene scene_of(double low, double high, double width, nlohmann::json material,
               const nlohmann::json& more) {
  material["rho0_kg_per_m3"] = dense_density;
  nlohmann::json changes = {{"environment",
                             {{"walls",
                               {wall("x_low", low), wall("x_high", high), wall("y_low", 0),
                                wall("y_high", width), wall("z_low", 0), wall("z_high", width)}}}},
                            {"material", material},
                            {"impactor", {{"material", {{"rho0_kg_per_m3", light_density}}}}},
                            {"numerics", {{"gravity_interval", 1}}}};
  changes.merge_patch(more);
  return lab_scene(changes);
}

}  // namespace

double layered_wave_ratio(int across) {
  constexpr double length = 1, K = 3e6, G = 1e6;
  const double d = length / across, width = 6 * d;
  const Scene scene =
      scene_of(-length, length, width, elastic_material(dense_density, K, G),
               {{"numerics", {{"viscosity_alpha", 0.05}, {"viscosity_beta", 0}, {"cfl", 0.2}}}});
  const double M = K + 4 * G / 3;
  const auto wave = [&](double rho) { return std::sqrt(M / rho); };
  const double c1 = wave(dense_density), c2 = wave(light_density);
  const auto mismatch = [&](double omega) {
    return dense_density * c1 / std::tan(omega * length / c1) +
           light_density * c2 / std::tan(omega * length / c2);
  };
  // Between a half wave in the dense half alone and none: the mismatch falls from + to - there.
  double low = 1e-6 * c1, high = pi * c1 / length * (1 - 1e-9);
  for (int k = 0; k < 100; ++k) (mismatch((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  const double omega = (low + high) / 2;

  particles::State state = two_layers(-length, length, d, width);
  std::vector<double> mode(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double x = state.x[i].x;
    mode[i] = x < 0 ? std::sin(omega * (x + length) / c1) / std::sin(omega * length / c1)
                    : std::sin(omega * (length - x) / c2) / std::sin(omega * length / c2);
    state.v[i] = {1e-4 * c1 * mode[i], 0, 0};
  }
  step::Solver solver(scene, std::move(state));
  const auto amplitude = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < solver.state().size(); ++i)
      sum += solver.state().v[i].x * mode[solver.state().id[i]];
    return sum;
  };
  const std::vector<double> crossings = zero_crossings(solver, amplitude, 2, 4 * pi / omega);
  if (crossings.size() < 2) return 0;
  return pi / (crossings[1] - crossings[0]) / omega;
}

LayeredLiquid layered_liquid(int across) {
  constexpr double depth = 1, g = 0.1, K = 1e6;  // of each layer, m; compressed by 4e-4
  const double d = depth / across, width = 6 * d;
  Scene scene =
      scene_of(-depth, 2 * depth, width,
               {{"eos", "linear"}, {"linear", {{"bulk_modulus_Pa", K}}}, {"rheology", "fluid"}},
               {{"environment", {{"gravity_m_per_s2", {-g, 0, 0}}}}});
  particles::State state = two_layers(-depth, depth, d, width);
  const auto pressure_at = [&](double x) {
    return x > 0 ? light_density * g * (depth - x)
                 : light_density * g * depth - dense_density * g * x;
  };
  for (std::size_t i = 0; i < state.size(); ++i) state.rho[i] *= 1 + pressure_at(state.x[i].x) / K;
  step::Solver solver(scene, std::move(state));
  const double crossing = 2 * depth / std::sqrt(K / dense_density), fall = std::sqrt(2 * depth / g);
  while (solver.state().time < 2 * fall) {
    const double before = solver.state().time;
    solver.cycle(2 * fall);
    if (solver.state().time < fall)
      solver.damp(std::exp((before - solver.state().time) / (4 * crossing)));
  }
  const particles::State& s = solver.state();
  LayeredLiquid found{};
  double light = 0, dense = 0, v2 = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    v2 += norm2(s.v[i]);
    found.voids += solver.pressure()[i] <= 0 ? 1 : 0;
    if (s.x[i].x > depth - 3 * d) continue;
    const bool is_dense = s.body[i] == static_cast<std::uint8_t>(particles::Body::target);
    (is_dense ? found.dense : found.light) += solver.pressure()[i] / pressure_at(s.x[i].x);
    (is_dense ? dense : light) += 1;
  }
  const auto n = static_cast<double>(s.size());
  found.light /= light, found.dense /= dense, found.voids /= n;
  found.speed = std::sqrt(v2 / n / (2 * g * depth));
  return found;
}

}  // namespace eerie::proof
