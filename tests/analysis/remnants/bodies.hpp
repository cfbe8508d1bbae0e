#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "solver/base/random.hpp"
#include "solver/base/tensor.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::test {

/// Rotation by `angle` about `axis` (Rodrigues).
inline Mat3 rotation(const Vec3& axis, double angle) {
  const Vec3 n = axis / norm(axis);
  Mat3 r;
  for (int i = 0; i < 3; ++i) {
    Vec3 e;
    e[i] = 1;
    const Vec3 column =
        std::cos(angle) * e + std::sin(angle) * cross(n, e) + (1 - std::cos(angle)) * dot(n, e) * n;
    for (int k = 0; k < 3; ++k) r[k][i] = column[k];
  }
  return r;
}

/// Cubic lattice of `spacing` inside the ellipsoid of the given half axes, m, about the origin.
/// Lattice points sit at half-integers, so that the body is symmetric.
inline std::vector<Vec3> ellipsoid(const Vec3& half, double spacing) {
  std::vector<Vec3> x;
  const auto steps = [&](double length) { return static_cast<int>(length / spacing) + 1; };
  for (int i = -steps(half.x); i < steps(half.x); ++i)
    for (int j = -steps(half.y); j < steps(half.y); ++j)
      for (int k = -steps(half.z); k < steps(half.z); ++k) {
        const Vec3 p{(i + 0.5) * spacing, (j + 0.5) * spacing, (k + 0.5) * spacing};
        const Vec3 s{p.x / half.x, p.y / half.y, p.z / half.z};
        if (norm2(s) <= 1) x.push_back(p);
      }
  return x;
}

inline std::vector<Vec3> moved(std::vector<Vec3> x, const Mat3& turn, const Vec3& by) {
  for (Vec3& p : x) p = turn * p + by;
  return x;
}

/// Velocities of a rigid body about the mean of `x`.
inline std::vector<Vec3> spinning(const std::vector<Vec3>& x, const Vec3& omega,
                                  const Vec3& drift) {
  Vec3 centre;
  for (const Vec3& p : x) centre += p / static_cast<double>(x.size());
  std::vector<Vec3> v;
  for (const Vec3& p : x) v.push_back(drift + cross(omega, p - centre));
  return v;
}

/// Lattice spacing and particle mass of the bodies below, m and kg: 2700 kg/m^3.
inline constexpr double spacing = 5;
inline constexpr double particle_mass_kg = 2700 * spacing * spacing * spacing;

/// Adds particles of one body to a state.
inline void add(particles::State& state, const std::vector<Vec3>& x, const std::vector<Vec3>& v,
                particles::Body body) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    state.id.push_back(static_cast<std::uint32_t>(state.id.size()));
    state.body.push_back(static_cast<std::uint8_t>(body));
    state.x.push_back(x[i]);
    state.v.push_back(v[i]);
    state.rho.push_back(2700);
    state.S.push_back({});
  }
}

inline particles::State empty_state() {
  particles::State state;
  state.mass = particle_mass_kg;
  state.h = 1.2 * spacing;
  return state;
}

/// Adds a body of the given half axes at `x`, moving with `v`.
inline void add_body(particles::State& state, const Vec3& half, const Vec3& x, const Vec3& v,
                     particles::Body body) {
  const std::vector<Vec3> points = moved(ellipsoid(half, spacing), Mat3::identity(), x);
  add(state, points, std::vector<Vec3>(points.size(), v), body);
}

inline io::Snapshot snapshot_of(const particles::State& state) {
  io::Snapshot snapshot;
  snapshot.scene = parse_scene(nlohmann::json::object());
  snapshot.state = state;
  snapshot.pressure.assign(state.size(), 0.0);
  return snapshot;
}

/// The same particles in another memory order.
inline particles::State shuffled(const particles::State& state, std::uint64_t seed) {
  Random random(seed, 0);
  std::vector<std::size_t> order(state.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  for (std::size_t i = order.size() - 1; i > 0; --i)
    std::swap(order[i],
              order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1))]);
  particles::State other = state;
  for (std::size_t i = 0; i < order.size(); ++i) {
    other.id[i] = state.id[order[i]];
    other.body[i] = state.body[order[i]];
    other.x[i] = state.x[order[i]];
    other.v[i] = state.v[order[i]];
    other.rho[i] = state.rho[order[i]];
    other.S[i] = state.S[order[i]];
  }
  return other;
}

}  // namespace eerie::test
