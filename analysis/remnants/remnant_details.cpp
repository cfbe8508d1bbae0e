#include "analysis/remnants/remnant_details.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/remnants/clumps.hpp"
#include "analysis/remnants/encounter.hpp"
#include "solver/base/constants.hpp"

namespace eerie::remnants {
namespace {
using nlohmann::json;

double tilt_of(const Vec3& spin, const Vec3& shortest_axis) {
  const double cosine = std::abs(dot(spin, shortest_axis)) / norm(spin);
  return degrees(std::acos(std::min(1.0, cosine)));
}

RemnantDetails describe(const io::Snapshot& snapshot, const Clump& clump, const Remnant& remnant,
                        std::span<const double> depths) {
  const particles::State& state = snapshot.state;
  std::vector<Vec3> x, v;
  std::vector<double> depths_here;
  for (const std::uint32_t i : clump) {
    x.push_back(state.x[i]), v.push_back(state.v[i]);
    if (!depths.empty()) depths_here.push_back(depths[state.id[i]]);
  }
  RemnantDetails d;
  d.neck = shapes::neck(x, remnant.shape.axes[0], state.h);
  d.shape_class = shapes::classify_shape(remnant.shape, d.neck);
  d.box = shapes::box_of_hull(x, shapes::particle_radius(snapshot));
  const shapes::Shape& s = remnant.shape;
  if (s.c > 0) d.bulk_density = remnant.mass / (pi / 6 * s.a * s.b * s.c);
  if (remnant.spin_period) d.spin = shapes::angular_velocity(x, v);
  if (d.spin) d.tilt = tilt_of(*d.spin, s.axes[2]);
  if (!depths.empty()) d.depth = origin_depth(std::move(depths_here));
  return d;
}

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

void add_orbit(json& out, const std::optional<Orbit>& orbit) {
  std::optional<double> pericentre, eccentricity, semi_major_axis, period_h, v_inf;
  if (orbit) {
    pericentre = orbit->pericentre, eccentricity = orbit->eccentricity;
    if (orbit->bound()) {
      semi_major_axis = -orbit->mu / (2 * orbit->specific_energy);
      period_h = 2 * pi * std::sqrt(cubed(*semi_major_axis) / orbit->mu) / 3600;
    } else {
      v_inf = std::sqrt(2 * orbit->specific_energy);
    }
  }
  out["orbit_pericentre_m"] = or_null(pericentre);
  out["orbit_eccentricity"] = or_null(eccentricity);
  out["orbit_semi_major_axis_m"] = or_null(semi_major_axis);
  out["orbit_period_h"] = or_null(period_h);
  out["orbit_v_inf_m_per_s"] = or_null(v_inf);
}

}  // namespace

std::vector<RemnantDetails> describe_remnants(const io::Snapshot& snapshot,
                                              std::span<const Remnant> remnants,
                                              std::span<const double> depths) {
  const particles::State& state = snapshot.state;
  const std::vector<Clump> clumps =
      friends_of_friends(state.x, state.id, linking_length_over_h * state.h);
  std::vector<RemnantDetails> all;
  for (std::size_t k = 0; k < remnants.size(); ++k) {
    all.push_back(describe(snapshot, clumps[k], remnants[k], depths));
    if (k > 0) all.back().orbit = relative_orbit(point(remnants[0]), point(remnants[k]));
  }
  return all;
}

json to_json(const RemnantDetails& d) {
  json out = {{"shape_class", shapes::name(d.shape_class)},
              {"neck", d.neck},
              {"box_a_m", d.box.a},
              {"box_b_m", d.box.b},
              {"box_c_m", d.box.c},
              {"box_b_over_a", d.box.b_over_a()},
              {"bulk_density_kg_per_m3", d.bulk_density > 0 ? json(d.bulk_density) : json()},
              {"spin_tilt_deg", or_null(d.tilt)}};
  const double rate = d.spin ? norm(*d.spin) : 0;
  out["spin_axis_x"] = d.spin ? json(d.spin->x / rate) : json();
  out["spin_axis_y"] = d.spin ? json(d.spin->y / rate) : json();
  out["spin_axis_z"] = d.spin ? json(d.spin->z / rate) : json();
  out["origin_depth_mean_m"] = d.depth ? json(d.depth->mean) : json();
  out["origin_depth_p10_m"] = d.depth ? json(d.depth->p10) : json();
  out["origin_depth_p90_m"] = d.depth ? json(d.depth->p90) : json();
  add_orbit(out, d.orbit);
  return out;
}

}  // namespace eerie::remnants
