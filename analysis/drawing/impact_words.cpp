#include "analysis/drawing/impact_words.hpp"

#include "analysis/drawing/grouped.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie::drawing {

Quoted impact_words(const Scene& scene) {
  const std::string impactor = has_two_materials(scene) ? " (impactor unlike)" : "";
  return marked_up(
      "q = {:g}, φ_d\u00a0= {:g}°{}, {:g} cm/s, {:g}°; {} particles per target, {}, seed {}",
      scene.impact.q, scene.material.drucker_prager.phi_d_deg, in_quotes(impactor),
      scene.impact.v_imp_cm_per_s, scene.impact.theta_imp_deg,
      in_quotes(grouped(scene.numerics.particles_per_target)), in_quotes(scene.numerics.scheme),
      scene.numerics.seed);
}

}  // namespace eerie::drawing
