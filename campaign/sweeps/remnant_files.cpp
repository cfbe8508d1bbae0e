#include "campaign/sweeps/remnant_files.hpp"

#include <set>
#include <string>
#include <tuple>

#include "solver/initial/remnant_body.hpp"

namespace eerie::sweeps {

void require_remnants(std::span<const Scene> scenes) {
  std::set<std::tuple<std::string, std::string, std::int64_t, double>> seen;
  for (const Scene& scene : scenes) {
    const Scene::Remnant& remnant = scene.target.remnant;
    if (remnant.file.empty()) continue;
    if (seen.emplace(remnant.file, remnant.sha256, scene.numerics.particles_per_target,
                     particle_mass(scene))
            .second)
      initial::require_remnant(scene);
  }
}

}  // namespace eerie::sweeps
