#include "solver/step/late.hpp"

#include <utility>

#include "solver/material/of_bodies.hpp"

namespace eerie::step {

Scene softened(Scene scene, const particles::Softening& softening) {
  const double moduli = softening.sound_speed * softening.sound_speed;
  scene.numerics.viscosity_alpha *= softening.viscosity_alpha();
  scene.material.tillotson.A_Pa *= moduli;
  scene.material.tillotson.B_Pa *= moduli;
  scene.material.linear.bulk_modulus_Pa *= moduli;
  scene.material.shear_modulus_Pa *= moduli;
  return scene;
}

particles::State with_softening(particles::State state, const std::vector<double>& pressure,
                                const Scene& scene, const particles::Softening& softening) {
  state.softening = softening;
  const material::OfBodies other(softened(scene, softening));
  other.visit_laws(state.body, [&](const auto& eos, const auto&) {
    for (std::size_t i = 0; i < state.size(); ++i)
      if (pressure[i] != 0) state.rho[i] = eos[i].density_at(pressure[i]);
  });
  return state;
}

}  // namespace eerie::step
