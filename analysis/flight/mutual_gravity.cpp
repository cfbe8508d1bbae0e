#include "analysis/flight/mutual_gravity.hpp"

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

}  // namespace

MutualGravity::Crowd MutualGravity::crowd(std::vector<Member> members, bool is_one_body) const {
  const std::size_t n = members.size();
  return {std::move(members), std::vector<Vec3>(n),       std::vector<Vec3>(n),
          tree::KdTree(n),    tree::Gravity(parameters_), is_one_body};
}

void MutualGravity::take(std::vector<RigidBody>& bodies, const std::vector<std::uint32_t>& id) {
  id_ = id;
  crowds_.clear();
  std::vector<Member> light;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const bool is_heavy = bodies[b].mass >= heavy_;
    if (is_heavy && !bodies[b].in_kd_order) sort_members(bodies[b], id);
    std::vector<Member> members;
    for (std::size_t k = 0; k < bodies[b].members.size(); ++k)
      (is_heavy ? members : light).push_back({b, k});
    if (is_heavy) crowds_.push_back(crowd(std::move(members), true));
  }
  if (!light.empty()) crowds_.push_back(crowd(std::move(light), false));
  evaluations_ = 0;
}

void MutualGravity::sort_light_ones(const std::vector<RigidBody>& bodies) {
  if (crowds_.empty() || crowds_.back().is_one_body) return;
  std::vector<Member>& members = crowds_.back().members;
  std::vector<Vec3> x;
  std::vector<std::uint32_t> ids;
  x.reserve(members.size());
  ids.reserve(members.size());
  for (const auto& [body, k] : members) {
    x.push_back(bodies[body].place(k));
    ids.push_back(id_[bodies[body].members[k]]);
  }
  std::vector<Member> sorted;
  sorted.reserve(members.size());
  for (const std::uint32_t k : tree::kd_order(x, ids)) sorted.push_back(members[k]);
  members = std::move(sorted);
}

std::vector<Pull> MutualGravity::pulls(const std::vector<RigidBody>& bodies) {
  if (evaluations_++ % evaluations_in_order == 0) sort_light_ones(bodies);
  for (Crowd& c : crowds_) {
    for (std::size_t k = 0; k < c.members.size(); ++k)
      c.x[k] = bodies[c.members[k].body].place(c.members[k].k), c.g[k] = {};
    c.tree.fit(c.x);
  }
  for (Crowd& source : crowds_)
    for (Crowd& target : crowds_) {
      if (&source == &target && source.is_one_body) continue;
      source.gravity.accelerations(source.tree, source.x, target.x,
                                   [&](std::size_t k, const Vec3& g) { target.g[k] += g; });
    }
  std::vector<Pull> pulls(bodies.size());
  for (const Crowd& c : crowds_)
    for (std::size_t k = 0; k < c.members.size(); ++k) {
      const std::size_t b = c.members[k].body;
      const Vec3 force = parameters_.particle_mass * c.g[k];
      pulls[b].force += force;
      pulls[b].torque += cross(c.x[k] - bodies[b].x, force);
    }
  return pulls;
}

}  // namespace eerie::flight
