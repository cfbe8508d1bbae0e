#include "analysis/flight/rigid_body.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace eerie {

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

/// R s R^T.
SymTensor turned(const SymTensor& s, const Mat3& r) {
  const Mat3 t = r * to_matrix(s) * transpose(r);
  return {t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]};
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

void turn_stress(const RigidBody& body, State& state) {
  for (const std::uint32_t i : body.members) state.S[i] = turned(state.S[i], body.turned);
}

/// Inertia and radius of offsets from the centre of mass.
void measure(RigidBody& body, double particle_mass) {
  body.inertia = {}, body.radius = 0;
  for (const Vec3& r : body.offsets) {
    const double r2 = norm2(r);
    body.inertia += particle_mass * SymTensor{r2 - r.x * r.x, r2 - r.y * r.y, r2 - r.z * r.z,
                                              -r.x * r.y,     -r.x * r.z,     -r.y * r.z};
    body.radius = std::max(body.radius, std::sqrt(r2));
  }
}

}  // namespace

Vec3 RigidBody::angular_velocity() const { return spin(eerie::turned(inertia, turned), L); }

void RigidBody::drift(double duration) {
  x += duration * v;
  const Mat3 before = turned;
  turned = rotation(duration / 2 * angular_velocity()) * before;
  turned = rotation(duration * angular_velocity()) * before;
}

RigidBody rigid_body(const State& state, Clump members) {
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

RigidBody stuck_together(const RigidBody& one, const RigidBody& other, State& state) {
  RigidBody body;
  body.mass = one.mass + other.mass;
  body.x = (one.mass * one.x + other.mass * other.x) / body.mass;
  body.v = (one.mass * one.v + other.mass * other.v) / body.mass;
  body.L =
      one.L + other.L + one.mass * other.mass / body.mass * cross(one.x - other.x, one.v - other.v);
  struct Placed {
    std::uint32_t member;
    Vec3 offset;
  };
  std::vector<Placed> all;
  for (const RigidBody* part : {&one, &other}) {
    turn_stress(*part, state);
    for (std::size_t k = 0; k < part->members.size(); ++k)
      all.push_back({part->members[k], part->place(k) - body.x});
  }
  std::ranges::sort(all, {}, [&](const Placed& p) { return state.id[p.member]; });
  for (const Placed& p : all) body.members.push_back(p.member), body.offsets.push_back(p.offset);
  measure(body, state.mass);
  return body;
}

void put_back(const RigidBody& body, State& state) {
  const Vec3 omega = body.angular_velocity();
  for (std::size_t k = 0; k < body.members.size(); ++k) {
    const std::uint32_t i = body.members[k];
    const Vec3 r = body.turned * body.offsets[k];
    state.x[i] = body.x + r;
    state.v[i] = body.v + cross(omega, r);
  }
  turn_stress(body, state);
}

}  // namespace eerie
