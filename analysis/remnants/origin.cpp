#include "analysis/remnants/origin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "solver/scene/body_shape.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::remnants {

std::vector<double> initial_depths(const io::Snapshot& first) {
  const particles::State& state = first.state;
  std::array<Vec3, 2> centre{};
  std::array<double, 2> particles{};
  for (std::size_t i = 0; i < state.size(); ++i)
    centre[state.body[i]] += state.x[i], particles[state.body[i]] += 1;
  for (std::size_t body = 0; body < 2; ++body)
    centre[body] = centre[body] / std::max(particles[body], 1.0);
  const std::array<double, 2> radius{first.scene.target.radius_m, impactor_radius(first.scene)};
  const std::array<BodyShape, 2> shape{target_shape(first.scene), impactor_shape(first.scene)};
  std::vector<double> depth(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const std::size_t body = state.body[i];
    depth[state.id[i]] =
        std::max(0.0, radius[body] - norm(shape[body].on_sphere(state.x[i] - centre[body])));
  }
  return depth;
}

OriginDepth origin_depth(std::vector<double> depths) {
  std::ranges::sort(depths);
  const auto quantile = [&](double part) {
    return depths[static_cast<std::size_t>(
        std::lround(part * static_cast<double>(depths.size() - 1)))];
  };
  const double sum = std::accumulate(depths.begin(), depths.end(), 0.0);
  return {sum / static_cast<double>(depths.size()), quantile(0.1), quantile(0.9)};
}

}  // namespace eerie::remnants
