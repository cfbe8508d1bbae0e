#include "analysis/flight/mutual_gravity.hpp"

#include <algorithm>
#include <utility>

namespace eerie::flight {

namespace {

/// Light bodies are sorted again every so many evaluations; within a rigid body order stays.
constexpr long evaluations_in_order = 16;

/// Members and offsets in kd order.
void sort_members(RigidBody& body, const std::vector<std::uint32_t>& id) {
  std::vector<std::uint32_t> ids;
  ids.reserve(body.members.size());
  for (const std::uint32_t i : body.members) ids.push_back(id[i]);
  body.reorder(tree::kd_order(body.offsets, ids));
  body.in_kd_order = true;
}

/// Lets a force act at x, m.
void act(Pull& pull, const RigidBody& body, const Vec3& x, const Vec3& force) {
  pull.force += force;
  pull.torque += cross(x - body.x, force);
}

}  // namespace

void MutualGravity::take(std::vector<RigidBody>& bodies, const std::vector<std::uint32_t>& id) {
  id_ = id;
  heavy_ones_.clear();
  light_ = {};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].mass >= heavy_) {
      if (!bodies[b].in_kd_order) sort_members(bodies[b], id);
      heavy_ones_.push_back(heavy(b, bodies[b]));
    } else {
      for (std::size_t k = 0; k < bodies[b].members.size(); ++k) light_.members.push_back({b, k});
    }
  }
  std::ranges::stable_sort(heavy_ones_, std::ranges::greater{},
                           [](const Heavy& one) { return one.particles.members.size(); });
  evaluations_ = 0;
}

MutualGravity::Heavy MutualGravity::heavy(std::size_t b, const RigidBody& body) const {
  Heavy one{b, {}, tree::KdTree(body.offsets.size()), tree::Gravity(parameters_)};
  for (std::size_t k = 0; k < body.offsets.size(); ++k) one.particles.members.push_back({b, k});
  one.tree.fit(body.offsets);
  return one;
}

void MutualGravity::sort_light_ones(const std::vector<RigidBody>& bodies) {
  std::vector<Vec3> x;
  std::vector<std::uint32_t> ids;
  x.reserve(light_.members.size());
  ids.reserve(light_.members.size());
  for (const auto& [body, k] : light_.members) {
    x.push_back(bodies[body].place(k));
    ids.push_back(id_[bodies[body].members[k]]);
  }
  std::vector<Crowd::Member> sorted;
  sorted.reserve(light_.members.size());
  for (const std::uint32_t k : tree::kd_order(x, ids)) sorted.push_back(light_.members[k]);
  light_.members = std::move(sorted);
}

std::vector<Pull> MutualGravity::pulls(const std::vector<RigidBody>& bodies) {
  if (evaluations_++ % evaluations_in_order == 0) sort_light_ones(bodies);
  const auto place = [&](Crowd& crowd) {
    crowd.x.clear();
    for (const auto& [body, k] : crowd.members) crowd.x.push_back(bodies[body].place(k));
  };
  place(light_);
  // The largest one is only asked in its own frame.
  for (std::size_t h = 1; h < heavy_ones_.size(); ++h) place(heavy_ones_[h].particles);

  std::vector<Pull> pulls(bodies.size());
  for (std::size_t source = 0; source < heavy_ones_.size(); ++source) {
    for (std::size_t target = source + 1; target < heavy_ones_.size(); ++target)
      pull(heavy_ones_[source], heavy_ones_[target].particles, bodies, pulls);
    pull(heavy_ones_[source], light_, bodies, pulls);
  }
  pull_light_ones(bodies, pulls);
  return pulls;
}

/// By the source on each particle of the crowd, and as much by all of them on the source.
void MutualGravity::pull(Heavy& source, const Crowd& crowd, const std::vector<RigidBody>& bodies,
                         std::vector<Pull>& pulls) {
  if (crowd.members.empty()) return;
  const RigidBody& body = bodies[source.body];
  const Mat3 back = transpose(body.turned);
  seen_.clear();
  for (const Vec3& x : crowd.x) seen_.push_back(back * (x - body.x));
  g_.resize(seen_.size());
  source.gravity.accelerations(source.tree, body.offsets, seen_,
                               [&](std::size_t k, const Vec3& g) { g_[k] = g; });
  for (std::size_t k = 0; k < crowd.members.size(); ++k) {
    const std::size_t b = crowd.members[k].body;
    const Vec3 force = parameters_.particle_mass * (body.turned * g_[k]);
    act(pulls[b], bodies[b], crowd.x[k], force);
    act(pulls[source.body], body, crowd.x[k], -force);
  }
}

void MutualGravity::pull_light_ones(const std::vector<RigidBody>& bodies,
                                    std::vector<Pull>& pulls) {
  if (light_.members.empty()) return;
  tree::KdTree tree(light_.members.size());
  tree.fit(light_.x);
  light_gravity_.accelerations(tree, light_.x, g_);
  for (std::size_t k = 0; k < light_.members.size(); ++k) {
    const std::size_t b = light_.members[k].body;
    act(pulls[b], bodies[b], light_.x[k], parameters_.particle_mass * g_[k]);
  }
}

}  // namespace eerie::flight
