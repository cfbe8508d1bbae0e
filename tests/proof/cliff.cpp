#include "tests/proof/cliff.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/remnants/clumps.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"

namespace eerie::proof {

namespace {

constexpr double g = 9.81, rho0 = 2000, L0 = 1;

/// Highest particles of the largest piece in columns two spacings wide.
Surface surface_of(const particles::State& s, double spacing, double time_unit) {
  const remnants::Clump pile =
      remnants::friends_of_friends(s.x, s.id, remnants::linking_length_over_h * s.h).front();
  Surface surface{s.time / time_unit, {}, {}, 0, 0, 0};
  for (const std::uint32_t i : pile) {
    surface.front = std::max(surface.front, (s.x[i].x + spacing / 2) / L0);
    surface.top = std::max(surface.top, (s.x[i].y + spacing / 2) / L0);
  }
  const double width = 2 * spacing / L0;
  const auto columns = static_cast<std::size_t>(std::ceil(surface.front / width));
  surface.y.assign(columns, 0);
  for (std::size_t k = 0; k < columns; ++k)
    surface.x.push_back(width * (static_cast<double>(k) + 0.5));
  for (const std::uint32_t i : pile) {
    const auto k = std::min(static_cast<std::size_t>(s.x[i].x / L0 / width), columns - 1);
    surface.y[k] = std::max(surface.y[k], (s.x[i].y + spacing / 2) / L0);
  }
  for (const Vec3& v : s.v) surface.kinetic_energy += norm2(v) / 2;
  return surface;
}

}  // namespace

std::vector<Surface> collapse(const Pile& pile, const std::vector<double>& times) {
  const double H0 = pile.aspect * L0, spacing = L0 / pile.across, depth = 3 * spacing;
  const double K = rho0 * pile.sound * pile.sound * 2 * g * H0;
  // Poisson's ratio 0.3.
  const Scene scene = lab_scene(
      {{"environment",
        {{"gravity_m_per_s2", {0, -g, 0}},
         {"walls",
          {wall("x_low", 0), wall("y_low", 0, "rough"), wall("z_low", 0), wall("z_high", depth)}}}},
       {"material",
        {{"rho0_kg_per_m3", rho0},
         {"eos", "linear"},
         {"linear", {{"bulk_modulus_Pa", K}}},
         {"shear_modulus_Pa", 0.46 * K},
         {"drucker_prager", {{"phi_d_deg", pile.phi_d_deg}}}}},
       {"numerics",
        {{"gravity_interval", 1},  // a new dt every step
         {"viscosity_alpha", pile.viscosity},
         {"viscosity_beta", 2 * pile.viscosity}}}});
  particles::State state = lattice_block({0, 0, 0}, {L0, H0, depth}, spacing, rho0);
  // At rest under its weight, or the whole column would bounce.
  for (std::size_t i = 0; i < state.size(); ++i)
    state.rho[i] *= 1 + rho0 * g * (H0 - state.x[i].y) / K;
  step::Solver solver(scene, std::move(state));
  const double time_unit = std::sqrt(H0 / g);
  std::vector<Surface> surfaces;
  for (const double time : times) {
    while (solver.state().time < time * time_unit) solver.cycle(time * time_unit);
    surfaces.push_back(surface_of(solver.state(), spacing, time_unit));
    surfaces.back().kinetic_energy /= static_cast<double>(solver.state().size()) * g * H0;
  }
  return surfaces;
}

double height_at(const Surface& surface, double x) {
  if (x >= surface.front) return 0;
  const auto& xs = surface.x;
  const auto next =
      static_cast<std::size_t>(std::upper_bound(xs.begin(), xs.end(), x) - xs.begin());
  if (next == 0) return surface.y.front();
  if (next == xs.size()) return surface.y.back();
  const double w = (x - xs[next - 1]) / (xs[next] - xs[next - 1]);
  return (1 - w) * surface.y[next - 1] + w * surface.y[next];
}

Surface published_start() {
  return {1,
          {.04, 1.0, 1.24, 1.48, 1.72, 1.96, 2.2},
          {2.03, 1.86, 1.67, 1.27, .90, .53, .21},
          2.4,
          2.03,
          0};
}

Surface published_end() {
  return {6,
          {.04, .52, 1.08, 1.56, 2.04, 2.52, 2.92, 3.4, 4.04, 4.76, 5.4, 6.04, 6.52, 7.0},
          {1.20, 1.05, .89, .756, .638, .536, .46, .364, .30, .241, .195, .123, .075, .038},
          7.2,
          1.2,
          0};
}

double mean_difference(const Surface& surface, const Surface& published) {
  double sum = 0;
  for (std::size_t k = 0; k < published.x.size(); ++k)
    sum += std::abs(height_at(surface, published.x[k]) - published.y[k]);
  return sum / static_cast<double>(published.x.size());
}

double reach_at_height(const Surface& surface, double height) {
  if (surface.y.back() >= height) return surface.front;  // a blunt end
  for (std::size_t k = surface.x.size(); k-- > 1;) {
    const double outer = surface.y[k], inner = surface.y[k - 1];
    if (inner >= height && outer < height)
      return surface.x[k] - (surface.x[k] - surface.x[k - 1]) * (height - outer) / (inner - outer);
  }
  return 0;
}

}  // namespace eerie::proof
