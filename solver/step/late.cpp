#include "solver/step/late.hpp"

#include <utility>
#include <variant>

namespace eerie::step {

Scene softened(Scene scene, double factor) {
  const double moduli = factor * factor;
  scene.material.tillotson.A_Pa *= moduli;
  scene.material.tillotson.B_Pa *= moduli;
  scene.material.linear.bulk_modulus_Pa *= moduli;
  scene.material.shear_modulus_Pa *= moduli;
  return scene;
}

particles::State with_softening(particles::State state, const std::vector<double>& pressure,
                                const Scene& scene, double softening) {
  state.softening = softening;
  const material::Material other = material::make_material(softened(scene, softening));
  std::visit(
      [&](const auto& eos) {
        for (std::size_t i = 0; i < state.size(); ++i)
          if (pressure[i] != 0) state.rho[i] = eos.density_at(pressure[i]);
      },
      other.eos);
  return state;
}

particles::State softened(particles::State state, const std::vector<double>& pressure,
                          const Scene& scene) {
  const double softening = state.softening * scene.numerics.late_sound_speed;
  return with_softening(std::move(state), pressure, scene, softening);
}

}  // namespace eerie::step
