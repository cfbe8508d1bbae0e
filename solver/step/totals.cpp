#include "solver/step/totals.hpp"

#include "solver/tree/gravity.hpp"

namespace eerie::step {

Totals totals(const Scene& scene, const particles::State& state) {
  std::vector<std::size_t> place(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) place[state.id[i]] = i;
  const auto [gx, gy, gz] = scene.environment.gravity_m_per_s2;
  const Vec3 uniform{gx, gy, gz};
  Totals t;
  for (const std::size_t i : place) {
    t.momentum += state.mass * state.v[i];
    t.angular_momentum += state.mass * cross(state.x[i], state.v[i]);
    t.kinetic_energy += 0.5 * state.mass * norm2(state.v[i]);
    t.potential_energy -= state.mass * dot(uniform, state.x[i]);
    if (state.u.empty()) continue;
    t.internal_energy += state.mass * state.u[i];
    t.viscous_heat += state.mass * state.viscous_heat[i];
    // Elastic energy of shear, S:S/(4 G) in a volume; what else the stress has worked is heat.
    const double G = scene.material.shear_modulus_Pa;
    const double elastic = G > 0 ? contract(state.S[i]) / (4 * G * state.rho[i]) : 0;
    t.shear_energy += state.mass * elastic;
    t.friction_heat += state.mass * (state.shear_work[i] - elastic);
  }
  t.mass = state.mass * static_cast<double>(state.size());
  if (!scene.environment.self_gravity) return t;
  tree::KdTree tree(state.size());
  tree.fit(state.x);
  t.potential_energy += tree::Gravity({state.mass, state.h, scene.numerics.opening_angle})
                            .potential_energy(tree, state.x);
  return t;
}

}  // namespace eerie::step
