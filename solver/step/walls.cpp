#include "solver/step/walls.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"

namespace eerie::step {

std::vector<tree::Mirror> mirrors(const Scene::Environment& environment) {
  std::vector<tree::Mirror> mirrors;
  for (const Scene::Wall& wall : environment.walls)
    mirrors.push_back(
        {wall.face[0] - 'x', wall.face.ends_with("_low"), wall.at_m, wall.kind == "rough"});
  return mirrors;
}

void require_walls_apart(const Scene::Environment& environment, double search_radius) {
  for (const tree::Mirror& low : mirrors(environment))
    for (const tree::Mirror& high : mirrors(environment))
      if (low.axis == high.axis && low.low && !high.low && high.at - low.at < search_radius)
        throw InputError(fmt::format(
            "scene.environment.walls: those of the {} axis are {:g} m apart and must be at least "
            "the reach of a particle, {:g} m; move them or take more particles",
            "xyz"[low.axis], high.at - low.at, search_radius));
}

}  // namespace eerie::step
