#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/remnants/analysis.hpp"
#include "solver/base/simd/pack.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"

// One small impact, told as JSON: which variant ran, where particles are after a few steps, and
// what came out. Built once for this machine and once for any x86-64.

namespace eerie {
namespace {

nlohmann::json positions(const particles::State& state) {
  std::vector<Vec3> x(state.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[state.id[i]] = state.x[i];
  nlohmann::json out = nlohmann::json::array();
  for (const Vec3& p : x) out.insert(out.end(), {p.x, p.y, p.z});
  return out;
}

nlohmann::json told() {
  const Scene scene =
      parse_scene({{"numerics", {{"particles_per_target", 200}, {"packing", "lattice"}}},
                   {"impact", {{"separation", 1.3}}},
                   {"end", {{"time_s", 2500}}}});
  step::Solver solver(scene, initial::make_unsettled_impact(scene));
  while (solver.state().step < 20) solver.cycle(scene.end.time_s);
  nlohmann::json out = {{"variant", vector_variant}, {"h_m", solver.state().h}};
  out["early_x_m"] = positions(solver.state());
  while (solver.state().time < scene.end.time_s) solver.cycle(scene.end.time_s);
  const remnants::Remnant largest =
      remnants::analyse({scene, solver.state(), solver.pressure(), {}, {}}).remnants.at(0);
  out["mass_over_total"] = largest.mass_over_total;
  out["a_m"] = largest.shape.a;
  out["b_over_a"] = largest.shape.b_over_a();
  return out;
}

}  // namespace
}  // namespace eerie

int main() { fmt::print("{}\n", eerie::told().dump()); }
