#include "analysis/light_curve/turning_remnant.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/remnants/remnants.hpp"
#include "analysis/shapes/hull.hpp"
#include "solver/base/constants.hpp"

namespace eerie::light_curve {
using nlohmann::json;

TurningRemnant remnant_of(const io::Snapshot& snapshot, int rank,
                          const std::filesystem::path& path) {
  const particles::State& state = snapshot.state;
  std::vector<Vec3> x, v;
  for (const std::uint32_t i : remnants::clump_of_rank(state, rank, path))
    x.push_back(state.x[i]), v.push_back(state.v[i]);
  TurningRemnant seen{spinning_body(x, shapes::particle_radius(snapshot)), {}, {}};
  if (const auto omega = shapes::angular_velocity(x, v); omega && norm(*omega) > 0) {
    seen.period = 2 * pi / norm(*omega);
    const double along_c = std::abs(dot(*omega, seen.body.shape.axes[2])) / norm(*omega);
    seen.tilt = std::acos(std::min(along_c, 1.0));
  }
  return seen;
}

json to_json(const TurningRemnant& seen, int rank) {
  const shapes::Shape& s = seen.body.shape;
  return {{"rank", rank},
          {"particles", seen.body.x.size()},
          {"particle_radius_m", seen.body.radius},
          {"a_m", s.a},
          {"b_m", s.b},
          {"c_m", s.c},
          {"b_over_a", s.b_over_a()},
          {"c_over_a", s.c_over_a()},
          {"spin_period_h", seen.period ? json(*seen.period / 3600) : json()},
          {"spin_from_shortest_axis_deg", seen.tilt ? json(degrees(*seen.tilt)) : json()}};
}

}  // namespace eerie::light_curve
