#include "tests/proof/spin_up.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/shapes/shape.hpp"
#include "solver/base/constants.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/ellipsoid.hpp"

namespace eerie::proof {

namespace {

double rate_of(const Scene& scene, double W) {
  return std::sqrt(W * 2 * pi * newton_G * scene.material.rho0_kg_per_m3);
}

/// What still lies within twice the radius: grains that have left say nothing about the body.
particles::State still_there(const particles::State& s, double radius) {
  particles::State body;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (norm(s.x[i]) < 2 * radius) body.x.push_back(s.x[i]), body.v.push_back(s.v[i]);
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
  found.c_over_a = shapes::ellipsoid_of_inertia(before).c_over_a();
  while (found.c_over_a > flat && solver.state().time < rise_s) {
    const double time = solver.state().time;
    solver.cycle(rise_s);
    solver.spin_up((solver.state().time - time) * torque);
    const Figure3 now = figure_of(scene, still_there(solver.state(), R));
    found.c_over_a = now.c_over_a;
    found.W_greatest = std::max(found.W_greatest, now.W);
  }
  const std::vector<Vec3> after = by_id(solver.state());
  // An even strain moves what lies at r by r: medians of r^3 in both shells.
  const double even = std::cbrt(0.6 * 0.6 * 0.6 / 2) / std::cbrt((1 + 0.9 * 0.9 * 0.9) / 2);
  found.interior =
      displacement(before, after, 0, 0.6 * R) / displacement(before, after, 0.9 * R, 2 * R) / even;
  const double end = solver.state().time + alone_s;
  while (solver.state().time < end) solver.cycle(end);
  const particles::State body = still_there(solver.state(), R);
  found.c_over_a_alone = figure_of(scene, body).c_over_a;
  found.shed = 1 - static_cast<double>(body.size()) / static_cast<double>(solver.state().size());
  return found;
}

}  // namespace eerie::proof
