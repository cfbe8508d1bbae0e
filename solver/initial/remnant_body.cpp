#include "solver/initial/remnant_body.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/sha256.hpp"
#include "solver/base/tensor.hpp"
#include "solver/io/snapshot.hpp"
#include "solver/scene/body_shape.hpp"

namespace eerie::initial {

namespace {

io::Snapshot read_remnant(const Scene::Remnant& from) {
  try {
    io::Snapshot snapshot = io::read_snapshot(from.file);  // which takes files only, no pipes
    if (sha256_hex(read_file(from.file)) == from.sha256) return snapshot;
  } catch (const EnvironmentError& error) {
    throw InputError(fmt::format("scene.target.remnant.file: {}", error.what()));
  }
  throw InputError(
      fmt::format("scene.target.remnant.file = \"{}\": its SHA-256 is not that of "
                  "scene.target.remnant.sha256; it is another file, or it has changed",
                  from.file));
}

void require_same_particles(const particles::State& s, const Scene& scene) {
  const auto n = static_cast<std::int64_t>(s.size());
  if (n != scene.numerics.particles_per_target)
    throw InputError(
        fmt::format("scene.numerics.particles_per_target = {}: the remnant has {} particles; "
                    "give {}",
                    scene.numerics.particles_per_target, n, n));
  const double ratio = s.mass / particle_mass(scene);
  if (std::abs(ratio - 1) > 1e-6)
    throw InputError(fmt::format(
        "scene.target.radius_m = {:.10g}: the remnant's particles have {:.4g} of the mass that "
        "follows; give {:.10g}",
        scene.target.radius_m, ratio, scene.target.radius_m * std::cbrt(ratio)));
}

particles::State checked_particles(const Scene& scene) {
  particles::State s = read_remnant(scene.target.remnant).state;
  require_same_particles(s, scene);
  return s;
}

}  // namespace

bool is_remnant(const Scene& scene, particles::Body body) {
  return body == particles::Body::target && !scene.target.remnant.file.empty();
}

void require_remnant(const Scene& scene) { checked_particles(scene); }

particles::State remnant_body(const Scene& scene) {
  particles::State s = checked_particles(scene);
  s.mass = particle_mass(scene);
  s.h = smoothing_length(scene);
  const auto [a, b, c] = target_shape(scene).directions();
  const Mat3 turn{{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}};
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.x[i] = turn * s.x[i];
    s.v[i] = turn * s.v[i];
    s.S[i] = turned(s.S[i], turn);
  }
  if (!has_energy(scene)) s.u.clear(), s.viscous_heat.clear(), s.shear_work.clear();
  if (!has_fracture(scene)) s.damage_cbrt.clear();
  return s;
}

}  // namespace eerie::initial
