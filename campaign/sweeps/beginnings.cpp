#include "campaign/sweeps/beginnings.hpp"

#include <set>
#include <string>
#include <tuple>

#include "solver/initial/bodies.hpp"
#include "solver/initial/remnant_body.hpp"
#include "solver/scene/tide.hpp"

namespace eerie::sweeps {

void require_beginnings(std::span<const Scene> scenes) {
  std::set<std::tuple<std::string, std::string, std::int64_t, double>> read;
  for (const Scene& scene : scenes) {
    // Without a primary the scene itself has asked for its orbit.
    if (has_primary(scene)) initial::require_orbit(scene);
    const Scene::Remnant& remnant = scene.target.remnant;
    if (remnant.file.empty()) continue;
    if (read.emplace(remnant.file, remnant.sha256, scene.numerics.particles_per_target,
                     particle_mass(scene))
            .second)
      initial::require_remnant(scene);
  }
}

}  // namespace eerie::sweeps
