#include "tests/proof/rings.hpp"

#include <cmath>

#include "analysis/remnants/clumps.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"

namespace eerie::proof {

RingsOutcome collide(const Rings& rings, double time) {
  constexpr double rho0 = 1000, E = 1e7, nu = 0.3975, inner = 0.03, outer = 0.04;
  constexpr double h_over_spacing = 1.5;
  const double K = E / (3 * (1 - 2 * nu)), G = E / (2 * (1 + nu)), c0 = std::sqrt(K / rho0);
  const double d = rings.spacing, depth = 4 * d, centre = outer + 2 * d;
  nlohmann::json walls = {wall("z_low", 0), wall("z_high", depth)};
  if (rings.quarter) walls.push_back(wall("x_low", 0)), walls.push_back(wall("y_low", 0));
  const Scene scene = lab_scene({{"environment", {{"walls", walls}}},
                                 {"material", elastic_material(rho0, K, G)},
                                 {"numerics",
                                  {{"artificial_stress", rings.artificial_stress},
                                   {"cfl", 0.8},
                                   {"gravity_interval", 1},
                                   {"precision", "double"}}}});
  const auto is_ring = [&](const Vec3& x) {
    const double r = std::hypot(std::abs(x.x) - centre, x.y);
    return inner < r && r < outer;
  };
  // Whole numbers of spacings, so that the planes of symmetry lie between particles.
  const double length = d * std::ceil((centre + outer) / d), width = d * std::ceil(outer / d);
  const bool quarter = rings.quarter;
  particles::State state = lattice_block({quarter ? 0 : -length, quarter ? 0 : -width, 0},
                                         {length, width, depth}, d, rho0, is_ring, h_over_spacing);
  std::vector<double> side;
  for (std::size_t i = 0; i < state.size(); ++i) {
    side.push_back(state.x[i].x > 0 ? 1 : -1);
    state.v[i].x = -0.059 * c0 * side.back();
  }
  step::Solver solver(scene, std::move(state));
  const double end = time * outer / c0;
  while (solver.state().time < end) solver.cycle(end);

  const particles::State& s = solver.state();
  const auto n = static_cast<double>(s.size());
  RingsOutcome outcome{};
  // Links as at h = 1.2 spacings.
  for (const remnants::Clump& piece :
       remnants::friends_of_friends(s.x, s.id, remnants::linking_length_over_h * 1.2 * d)) {
    const double share = static_cast<double>(piece.size()) / n;
    outcome.largest_piece = std::max(outcome.largest_piece, share);
    if (share >= 0.01) ++outcome.pieces;
  }
  for (std::size_t i = 0; i < s.size(); ++i) {
    outcome.rebound += s.v[i].x * side[s.id[i]] / (0.059 * c0) / n;
    if (s.x[i].z < d) outcome.x.push_back(s.x[i]);
  }
  return outcome;
}

}  // namespace eerie::proof
