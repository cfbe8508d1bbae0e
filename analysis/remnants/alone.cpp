#include "analysis/remnants/alone.hpp"

#include <algorithm>

#include "analysis/remnants/clumps.hpp"
#include "analysis/remnants/remnants.hpp"
#include "solver/base/mean.hpp"
#include "solver/base/tensor.hpp"

namespace eerie::remnants {

namespace {

/// The particles of a clump in the order of their ids, with ids of their own.
particles::State members(const particles::State& all, const Clump& clump) {
  particles::State s = all;
  particles::visit_state(s, [&](const char*, auto& array) {
    std::decay_t<decltype(array)> picked;
    picked.reserve(clump.size());
    for (const std::uint32_t i : clump) picked.push_back(array[i]);
    array = std::move(picked);
  });
  for (std::uint32_t i = 0; i < s.size(); ++i) s.id[i] = i;
  std::ranges::fill(s.body, static_cast<std::uint8_t>(particles::Body::target));
  s.time = 0, s.step = 0, s.softening = {};
  return s;
}

/// The rotation that turns the axes of a shape to those of space. Of the two that do, the one
/// after which the spin points up.
Mat3 upright(const shapes::Shape& shape, const particles::State& s) {
  auto [a, b, c] = shape.axes;
  if (const auto omega = shapes::angular_velocity(s.x, s.v); omega && dot(*omega, c) < 0)
    b = -b, c = -c;
  return {{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}};
}

}  // namespace

Alone alone(const io::Snapshot& from, int rank, const std::filesystem::path& path) {
  const Clump clump = clump_of_rank(from.state, rank, path);
  Alone found{{from.scene, members(from.state, clump), {}, {}, {}}, {}};
  for (const std::uint32_t i : clump) found.snapshot.pressure.push_back(from.pressure.at(i));
  particles::State& s = found.snapshot.state;
  take_off_mean(s.x), take_off_mean(s.v);
  const Mat3 turn = upright(shapes::ellipsoid_of_inertia(s.x), s);
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.x[i] = turn * s.x[i], s.v[i] = turn * s.v[i];
    s.S[i] = turned(s.S[i], turn);
  }
  found.shape = shapes::ellipsoid_of_inertia(s.x);
  return found;
}

}  // namespace eerie::remnants
