#include "tests/proof/spin_up.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/shapes/shape.hpp"
#include "solver/base/constants.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"

namespace eerie::proof {

namespace {

double rate_of(const Scene& scene, double W) {
  return std::sqrt(W * 2 * pi * newton_G * scene.material.rho0_kg_per_m3);
}

/// What still lies within twice the radius: grains that have left say nothing about the body.
struct Body {
  std::vector<Vec3> x, v;
  double shed;
};
Body body_of(const particles::State& s, double radius) {
  Body body;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (norm(s.x[i]) < 2 * radius) body.x.push_back(s.x[i]), body.v.push_back(s.v[i]);
  body.shed = 1 - static_cast<double>(body.x.size()) / static_cast<double>(s.size());
  return body;
}

std::vector<Vec3> by_id(const particles::State& s) {
  std::vector<Vec3> x(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) x[s.id[i]] = s.x[i];
  return x;
}

/// Median displacement away from the axis and along it, of what lay between two radii.
double displacement(const std::vector<Vec3>& before, const std::vector<Vec3>& after, double inner,
                    double outer) {
  std::vector<double> moved;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec3 &b = before[i], &a = after[i];
    if (norm(b) < inner || norm(b) >= outer) continue;
    moved.push_back(std::hypot(std::hypot(a.x, a.y) - std::hypot(b.x, b.y), a.z - b.z));
  }
  const auto middle = moved.begin() + static_cast<std::ptrdiff_t>(moved.size() / 2);
  std::ranges::nth_element(moved, middle);
  return *middle;
}

}  // namespace

SpinUpOfSphere spin_up_of_sphere(const Scene& scene, double W_begin, double rise_s, double flat,
                                 double alone_s) {
  const double R = scene.target.radius_m;
  particles::State begin = initial::make_body(scene, particles::Body::target);
  for (std::size_t i = 0; i < begin.size(); ++i)
    begin.v[i] = cross({0, 0, rate_of(scene, W_begin)}, begin.x[i]);
  step::Solver solver(scene, std::move(begin));
  const std::vector<Vec3> before = by_id(solver.state());
  const Vec3 torque = {0, 0, rate_of(scene, 1) / rise_s};
  SpinUpOfSphere found{};
  shapes::Shape shape = shapes::ellipsoid_of_inertia(before);
  while (shape.c_over_a() > flat && solver.state().time < rise_s) {
    const double time = solver.state().time;
    solver.cycle(rise_s);
    solver.spin_up((solver.state().time - time) * torque);
    const Body body = body_of(solver.state(), R);
    shape = shapes::ellipsoid_of_inertia(body.x);
    const auto omega = shapes::angular_velocity(body.x, body.v);
    const double slowed = omega ? norm(*omega) / rate_of(scene, 1) : 0;
    found.W_greatest = std::max(found.W_greatest, slowed * slowed);
  }
  found.c_over_a = shape.c_over_a();
  const std::vector<Vec3> after = by_id(solver.state());
  // An even strain moves what lies at r by r: medians of r^3 in both shells.
  const double even = std::cbrt(0.6 * 0.6 * 0.6 / 2) / std::cbrt((1 + 0.9 * 0.9 * 0.9) / 2);
  found.interior =
      displacement(before, after, 0, 0.6 * R) / displacement(before, after, 0.9 * R, 2 * R) / even;
  const double end = solver.state().time + alone_s;
  while (solver.state().time < end) solver.cycle(end);
  const Body body = body_of(solver.state(), R);
  found.c_over_a_alone = shapes::ellipsoid_of_inertia(body.x).c_over_a();
  found.shed = body.shed;
  return found;
}

}  // namespace eerie::proof
