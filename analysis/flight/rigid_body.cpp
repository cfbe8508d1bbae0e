#include "analysis/flight/rigid_body.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace eerie::flight {

namespace {

/// Principal moments below this part of the largest are none: lines and points.
constexpr double least_moment = 1e-12;

/// Rotation by |angle| rad about angle (Rodrigues).
Mat3 rotation(const Vec3& angle) {
  const double a = norm(angle);
  if (a == 0) return Mat3::identity();
  const Vec3 n = angle / a;
  const double s = std::sin(a), c = 2 * std::pow(std::sin(a / 2), 2);
  return {{{1 - c * (n.y * n.y + n.z * n.z), c * n.x * n.y - s * n.z, c * n.x * n.z + s * n.y},
           {c * n.x * n.y + s * n.z, 1 - c * (n.x * n.x + n.z * n.z), c * n.y * n.z - s * n.x},
           {c * n.x * n.z - s * n.y, c * n.y * n.z + s * n.x, 1 - c * (n.x * n.x + n.y * n.y)}}};
}

/// I^-1 L without a part about axes that have no inertia.
Vec3 spin(const SymTensor& I, const Vec3& L) {
  Eigen::Matrix3d inertia;
  inertia << I.xx, I.xy, I.xz, I.xy, I.yy, I.yz, I.xz, I.yz, I.zz;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia);
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const double moment = principal.eigenvalues()[k];
    if (moment <= least_moment * principal.eigenvalues()[2]) continue;
    const Eigen::Vector3d axis = principal.eigenvectors().col(k);
    omega += axis.dot(Eigen::Vector3d(L.x, L.y, L.z)) / moment * axis;
  }
  return {omega.x(), omega.y(), omega.z()};
}

void turn_stress(const remnants::Clump& members, const Mat3& rotation, particles::State& state) {
  for (const std::uint32_t i : members) state.S[i] = turned(state.S[i], rotation);
}

void make_blocks(RigidBody& body) {
  constexpr std::size_t size = RigidBody::block_size;
  body.blocks.assign((body.offsets.size() + size - 1) / size, {});
  for (std::size_t k = 0; k < body.offsets.size(); ++k)
    body.blocks[k / size].include(body.offsets[k]);
}

/// Inertia, radius and blocks of offsets from the centre of mass.
void measure(RigidBody& body, double particle_mass) {
  body.inertia = {}, body.radius = 0;
  for (const Vec3& r : body.offsets) {
    const double r2 = norm2(r);
    body.inertia += particle_mass * SymTensor{r2 - r.x * r.x, r2 - r.y * r.y, r2 - r.z * r.z,
                                              -r.x * r.y,     -r.x * r.z,     -r.y * r.z};
    body.radius = std::max(body.radius, std::sqrt(r2));
  }
  make_blocks(body);
}

/// Whether a place, from the centre of mass and not turned, is so near to any particle.
bool is_near(const Vec3& place, const RigidBody& body, double contact) {
  const double contact2 = contact * contact;
  for (std::size_t block = 0; block < body.blocks.size(); ++block) {
    if (distance2(body.blocks[block], place) > contact2) continue;
    const std::size_t first = block * RigidBody::block_size;
    const std::size_t end = std::min(first + RigidBody::block_size, body.offsets.size());
    for (std::size_t k = first; k < end; ++k)
      if (norm2(body.offsets[k] - place) < contact2) return true;
  }
  return false;
}

}  // namespace

Vec3 RigidBody::angular_velocity() const { return spin(eerie::turned(inertia, turned), L); }

void RigidBody::drift(double duration) {
  x += duration * v;
  const Mat3 before = turned;
  turned = rotation(duration / 2 * angular_velocity()) * before;
  turned = rotation(duration * angular_velocity()) * before;
}

void RigidBody::reorder(const std::vector<std::uint32_t>& order) {
  const remnants::Clump old_members = members;
  const std::vector<Vec3> old_offsets = offsets;
  for (std::size_t k = 0; k < order.size(); ++k)
    members[k] = old_members[order[k]], offsets[k] = old_offsets[order[k]];
  make_blocks(*this);
}

bool touch(const RigidBody& one, const RigidBody& other, double contact) {
  const double reach = one.radius + other.radius + contact;
  if (norm2(one.x - other.x) > reach * reach) return false;
  const auto& [small, large] =
      one.members.size() < other.members.size() ? std::tie(one, other) : std::tie(other, one);
  const Mat3 back = transpose(large.turned);
  for (std::size_t k = 0; k < small.members.size(); ++k)
    if (is_near(back * (small.place(k) - large.x), large, contact)) return true;
  return false;
}

RigidBody rigid_body(const particles::State& state, remnants::Clump members) {
  RigidBody body;
  body.members = std::move(members);
  const auto n = static_cast<double>(body.members.size());
  body.mass = n * state.mass;
  for (const std::uint32_t i : body.members) body.x += state.x[i], body.v += state.v[i];
  body.x = body.x / n, body.v = body.v / n;
  for (const std::uint32_t i : body.members) {
    body.offsets.push_back(state.x[i] - body.x);
    body.L += state.mass * cross(body.offsets.back(), state.v[i] - body.v);
  }
  measure(body, state.mass);
  return body;
}

RigidBody stuck_together(RigidBody one, RigidBody other, particles::State& state) {
  if (one.members.size() < other.members.size()) std::swap(one, other);
  const double mass = one.mass + other.mass;
  const Vec3 x = (one.mass * one.x + other.mass * other.x) / mass;
  const Vec3 v = (one.mass * one.v + other.mass * other.v) / mass;
  one.L += other.L + one.mass * other.mass / mass * cross(one.x - other.x, one.v - other.v);
  // The larger one's frame stays, so that little has to be turned.
  const Mat3 into = transpose(one.turned);
  const Vec3 shift = into * (one.x - x);
  for (Vec3& offset : one.offsets) offset += shift;
  turn_stress(other.members, into * other.turned, state);
  for (std::size_t k = 0; k < other.members.size(); ++k) {
    one.members.push_back(other.members[k]);
    one.offsets.push_back(into * (other.place(k) - x));
  }
  one.mass = mass, one.x = x, one.v = v;
  one.in_kd_order = false;
  measure(one, state.mass);
  return one;
}

void put_back(const RigidBody& body, particles::State& state) {
  const Vec3 omega = body.angular_velocity();
  for (std::size_t k = 0; k < body.members.size(); ++k) {
    const std::uint32_t i = body.members[k];
    const Vec3 r = body.turned * body.offsets[k];
    state.x[i] = body.x + r;
    state.v[i] = body.v + cross(omega, r);
  }
  turn_stress(body.members, body.turned, state);
}

}  // namespace eerie::flight
