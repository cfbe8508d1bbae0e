#include "solver/step/late.hpp"

#include <variant>

namespace eerie {

Scene softened(Scene scene, double factor) {
  const double moduli = factor * factor;
  scene.material.tillotson.A_Pa *= moduli;
  scene.material.tillotson.B_Pa *= moduli;
  scene.material.linear.bulk_modulus_Pa *= moduli;
  scene.material.shear_modulus_Pa *= moduli;
  return scene;
}

State softened(State state, const std::vector<double>& pressure, const Scene& scene) {
  state.softening *= scene.numerics.late_sound_speed;
  const Material softer = make_material(softened(scene, state.softening));
  std::visit(
      [&](const auto& eos) {
        for (std::size_t i = 0; i < state.size(); ++i)
          if (pressure[i] != 0) state.rho[i] = eos.density_at(pressure[i]);
      },
      softer.eos);
  return state;
}

}  // namespace eerie
