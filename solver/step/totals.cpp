#include "solver/step/totals.hpp"

#include "solver/tree/gravity.hpp"

namespace eerie {

Totals totals(const Scene& scene, const State& state) {
  std::vector<std::size_t> place(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) place[state.id[i]] = i;
  Totals t;
  for (const std::size_t i : place) {
    t.momentum += state.mass * state.v[i];
    t.angular_momentum += state.mass * cross(state.x[i], state.v[i]);
    t.kinetic_energy += 0.5 * state.mass * norm2(state.v[i]);
  }
  t.mass = state.mass * static_cast<double>(state.size());
  KdTree tree(state.size());
  tree.fit(state.x);
  t.potential_energy =
      Gravity({state.mass, state.h, scene.numerics.opening_angle}).potential_energy(tree, state.x);
  return t;
}

}  // namespace eerie
