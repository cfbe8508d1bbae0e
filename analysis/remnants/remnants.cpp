#include "analysis/remnants/remnants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/remnants/binding.hpp"
#include "analysis/remnants/clumps.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"

namespace eerie::remnants {

namespace {

/// Surface speeds below this part of the particles' speeds are rounding, not spin.
constexpr double spin_resolution = 1e-9;

std::vector<Vec3> picked(const std::vector<Vec3>& all, const Clump& clump) {
  std::vector<Vec3> some;
  some.reserve(clump.size());
  for (const std::uint32_t i : clump) some.push_back(all[i]);
  return some;
}

PointMass centre_of_mass(const particles::State& state, const Clump& clump) {
  const double n = static_cast<double>(clump.size());
  PointMass sum{state.mass * n, {}, {}};
  for (const std::uint32_t i : clump) sum.x += state.x[i], sum.v += state.v[i];
  sum.x = sum.x / n, sum.v = sum.v / n;
  return sum;
}

Remnant measure(const particles::State& state, const Clump& clump, const PointMass& centre) {
  const double n = static_cast<double>(clump.size());
  Remnant r;
  r.particles = clump.size();
  r.mass = centre.mass, r.x = centre.x, r.v = centre.v;
  r.mass_over_total = n / static_cast<double>(state.size());
  const std::vector<Vec3> x = picked(state.x, clump), v = picked(state.v, clump);
  r.shape = shapes::ellipsoid_of_inertia(x);
  double fastest2 = 0;
  for (const Vec3& speed : v) fastest2 = std::max(fastest2, norm2(speed));
  if (const auto omega = shapes::angular_velocity(x, v);
      omega && norm(*omega) * r.shape.a > spin_resolution * std::sqrt(fastest2))
    r.spin_period = 2 * pi / norm(*omega);
  r.eer = r.shape.b_over_a() < eer_max_b_over_a;
  const auto from_target = std::ranges::count_if(clump, [&](std::uint32_t i) {
    return state.body[i] == static_cast<std::uint8_t>(particles::Body::target);
  });
  r.target_fraction = static_cast<double>(from_target) / n;
  return r;
}

}  // namespace

Remnants find_remnants(const particles::State& state) {
  const std::vector<Clump> clumps =
      friends_of_friends(state.x, state.id, linking_length_over_h * state.h);
  std::vector<PointMass> points;
  points.reserve(clumps.size());
  for (const Clump& clump : clumps) points.push_back(centre_of_mass(state, clump));
  const auto first_debris = std::ranges::find_if(
      clumps, [](const Clump& clump) { return clump.size() < remnant_min_particles; });
  const auto cores = static_cast<std::size_t>(first_debris - clumps.begin());

  Remnants found;
  for (std::size_t k = 0; k < cores; ++k) {
    found.remnants.push_back(measure(state, clumps[k], points[k]));
    found.remnants.back().rank = static_cast<int>(k) + 1;
  }
  const double total = state.mass * static_cast<double>(state.size());
  for (const BoundGroup& group : bound_groups(points, cores)) {
    found.group_masses.push_back(group.sum.mass);
    found.group_cores.push_back(points[group.members.front()].mass);
    for (const std::size_t member : group.members) {
      if (member < cores) {
        found.remnants[member].bound_group = static_cast<int>(found.group_masses.size());
        found.remnants[member].bound_mass_over_total = group.sum.mass / total;
      } else if (group.members.size() > 1) {
        found.debris_bound_mass += points[member].mass;
      }
    }
  }
  found.debris.assign(points.begin() + static_cast<std::ptrdiff_t>(cores), points.end());
  return found;
}

Clump clump_of_rank(const particles::State& state, int rank, const std::filesystem::path& path) {
  std::vector<Clump> clumps =
      friends_of_friends(state.x, state.id, linking_length_over_h * state.h);
  const auto remnants = std::ranges::count_if(
      clumps, [](const Clump& clump) { return clump.size() >= remnant_min_particles; });
  if (rank > remnants)
    throw InputError(fmt::format("--remnant {}: {} holds {} remnant{} of at least {} particles",
                                 rank, path.string(), remnants, remnants == 1 ? "" : "s",
                                 remnant_min_particles));
  return std::move(clumps[static_cast<std::size_t>(rank - 1)]);
}

}  // namespace eerie::remnants
