#pragma once

#include <map>
#include <nlohmann/json.hpp>

#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"

namespace eerie::bench {

inline Scene scene(long particles_per_target, const std::string& precision = "float") {
  return parse_scene(
      {{"numerics", {{"particles_per_target", particles_per_target}, {"precision", precision}}}});
}

/// The two bodies at the start of the reference impact, in memory order. Made once per size.
inline const particles::State& bodies(long particles_per_target) {
  static std::map<long, particles::State> made;
  auto& state = made[particles_per_target];
  if (state.size() == 0) {
    const Scene s = scene(particles_per_target);
    state = step::Solver(s, initial::make_impact(s)).state();
  }
  return state;
}

}  // namespace eerie::bench
