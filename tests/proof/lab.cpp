#include "tests/proof/lab.hpp"

#include <cmath>

namespace eerie::proof {

particles::State lattice_block(const Vec3& lo, const Vec3& hi, double spacing, double rho,
                               const std::function<bool(const Vec3&)>& inside,
                               double h_over_spacing, double jitter) {
  Random random(1, 99);
  particles::State s;
  s.mass = rho * spacing * spacing * spacing;
  s.h = h_over_spacing * spacing;
  const auto count = [&](int k) { return std::lround((hi[k] - lo[k]) / spacing); };
  for (long a = 0; a < count(0); ++a)
    for (long b = 0; b < count(1); ++b)
      for (long c = 0; c < count(2); ++c) {
        const Vec3 site =
            lo + spacing * Vec3{static_cast<double>(a) + 0.5, static_cast<double>(b) + 0.5,
                                static_cast<double>(c) + 0.5};
        const Vec3 x = site + (jitter * spacing * random.uniform()) * random.direction();
        if (!inside || inside(site)) s.x.push_back(x);
      }
  particles::resize(s, s.x.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.id[i] = static_cast<std::uint32_t>(i);
    s.rho[i] = rho;
  }
  return s;
}

Scene lab_scene(const nlohmann::json& changes) {
  nlohmann::json scene = {{"environment", {{"self_gravity", false}}}};
  scene.merge_patch(changes);
  return parse_scene(scene);
}

nlohmann::json elastic_material(double rho0, double bulk_modulus, double shear_modulus) {
  return {{"rho0_kg_per_m3", rho0},
          {"eos", "linear"},
          {"linear", {{"bulk_modulus_Pa", bulk_modulus}}},
          {"shear_modulus_Pa", shear_modulus},
          {"rheology", "elastic"}};
}

std::vector<double> zero_crossings(step::Solver& solver, const std::function<double()>& amplitude,
                                   std::size_t count, double end_s) {
  std::vector<double> crossings;
  double before = amplitude(), time = solver.state().time;
  while (crossings.size() < count && time < end_s) {
    solver.cycle(end_s);
    const double now = amplitude();
    if (before * now < 0)
      crossings.push_back(time + (solver.state().time - time) * before / (before - now));
    before = now, time = solver.state().time;
  }
  return crossings;
}

nlohmann::json wall(const char* face, double at, const char* kind) {
  return {{"face", face}, {"at_m", at}, {"kind", kind}};
}

}  // namespace eerie::proof
