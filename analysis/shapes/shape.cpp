#include "analysis/shapes/shape.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>

namespace eerie::shapes {

namespace {

/// A second moment below this part of the largest is rounding, not extent.
constexpr double flat = 1e-12;

Vec3 mean(std::span<const Vec3> values) {
  Vec3 sum;
  for (const Vec3& v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 vec3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// <(x - <x>) (x - <x>)^T>, m^2.
Eigen::Matrix3d second_moments(std::span<const Vec3> x) {
  const Vec3 centre = mean(x);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Vec3& point : x) {
    const Eigen::Vector3d r = eigen(point - centre);
    sum += r * r.transpose();
  }
  return sum / static_cast<double>(x.size());
}

}  // namespace

Shape ellipsoid_of_inertia(std::span<const Vec3> x) {
  Shape shape;
  if (x.size() < 4) {
    shape.degenerate = fmt::format("{} particles span no volume", x.size());
    if (x.empty()) return shape;
  }
  // With the principal second moments qa >= qb >= qc (I1 = M (qa + qb), I2 = M (qa + qc),
  // I3 = M (qb + qc)), I1 + I2 - I3 = 2 M qa: a = sqrt(20 qa), and alike for b and c. Free of the
  // cancellation that makes c of a rod the root of a negative number.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second_moments(x));
  const Eigen::Vector3d q = solver.eigenvalues().reverse();
  const auto length = [&](int k) { return q[k] > flat * q[0] ? std::sqrt(20 * q[k]) : 0.0; };
  shape.a = length(0), shape.b = length(1), shape.c = length(2);
  const Vec3 along_a = vec3(solver.eigenvectors().col(2));
  const Vec3 along_b = vec3(solver.eigenvectors().col(1));
  shape.axes = {along_a, along_b, cross(along_a, along_b)};
  if (shape.degenerate.empty() && shape.c == 0)
    shape.degenerate =
        shape.b == 0 ? "the particles lie on a line" : "the particles lie in a plane";
  return shape;
}

std::optional<Vec3> angular_velocity(std::span<const Vec3> x, std::span<const Vec3> v) {
  if (x.empty()) return std::nullopt;
  const Eigen::Matrix3d q = second_moments(x);
  const Vec3 centre = mean(x), drift = mean(v);
  Vec3 spin;  // angular momentum over mass
  for (std::size_t i = 0; i < x.size(); ++i) spin += cross(x[i] - centre, v[i] - drift);
  spin = spin / static_cast<double>(x.size());
  const Eigen::Matrix3d inertia = q.trace() * Eigen::Matrix3d::Identity() - q;  // over mass
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  if (!(solver.eigenvalues()[0] > flat * solver.eigenvalues()[2])) return std::nullopt;
  const Eigen::Vector3d along_axes = solver.eigenvectors().transpose() * eigen(spin);
  return vec3(solver.eigenvectors() * along_axes.cwiseQuotient(solver.eigenvalues()));
}

}  // namespace eerie::shapes
