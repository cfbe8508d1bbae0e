#include "solver/scene/guards.hpp"

#include <fmt/format.h>

#include "solver/scene/tide.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie {

namespace {

/// Largest Courant number at which a body of rubble stays at rest.
double restful_cfl(const Scene::Numerics& n) {
  if (n.integrator == "leapfrog-pece") return 1.0;
  if (n.integrator == "staggered") return 1.2;
  return n.viscosity_alpha < 0.5 || n.viscosity_particles > n.particles_per_target ? 0.4 : 0.55;
}

/// With the smoothing length of numerics.viscosity_particles.
double effective_alpha(const Scene& s) {
  return s.numerics.viscosity_alpha * viscosity_length_ratio(s);
}

/// One line that a scene may cross.
struct Guard {
  const char* field;
  double (*value)(const Scene&);
  bool (*crossed)(const Scene&);
  const char* consequence;
};

/// The lines of docs/notebook/stability.md.
const Guard guards[] = {
    {"numerics.cfl", [](const Scene& s) { return s.numerics.cfl; },
     [](const Scene& s) { return s.numerics.cfl > restful_cfl(s.numerics); },
     "bodies do not come to rest and viscosity carries load that friction cannot feel; use 0.5 "
     "(0.4 where viscosity_alpha is below 0.5), 0.8 by leapfrog-pece, 1.1 by staggered"},
    {"numerics.gravity_tolerance", [](const Scene& s) { return s.numerics.gravity_tolerance; },
     [](const Scene& s) { return s.numerics.gravity_tolerance > 1e-3; },
     "time step and gravity are held for too long; use 1e-4"},
    {"numerics.opening_angle", [](const Scene& s) { return s.numerics.opening_angle; },
     [](const Scene& s) { return s.numerics.opening_angle > 0.5; },
     "the tree's net torque moves the angular momentum by more than 1e-3 over an impact; use 0.35"},
    {"numerics.h_over_spacing", [](const Scene& s) { return s.numerics.h_over_spacing; },
     [](const Scene& s) {
       return s.numerics.kernel == "cubic-spline" && s.numerics.h_over_spacing > 1.35;
     },
     "particles pair under the cubic spline; use 1.2, or a Wendland kernel"},
    {"numerics.h_over_spacing", [](const Scene& s) { return s.numerics.h_over_spacing; },
     [](const Scene& s) { return s.numerics.h_over_spacing < 1; },
     "too few neighbours for a gradient; use 1.2"},
    {"numerics.viscosity_alpha", effective_alpha,
     [](const Scene& s) { return effective_alpha(s) < 0.1; },
     "nothing damps the shortest waves, and particles of one body fly into the other; use 0.3 to "
     "1"},
    {"numerics.viscosity_alpha", effective_alpha,
     [](const Scene& s) { return effective_alpha(s) > 1.5; },
     "viscosity carries most of the load in place of friction and remnants become stout; use 1 or "
     "less"},
    {"numerics.list_skin", [](const Scene& s) { return s.numerics.list_skin; },
     [](const Scene& s) { return s.numerics.list_skin > 0.4; },
     "lists hold twice the pairs that count, which costs time and nothing else; use 0.1"},
    {"numerics.particles_per_target",
     [](const Scene& s) { return static_cast<double>(s.numerics.particles_per_target); },
     [](const Scene& s) { return s.numerics.particles_per_target < 1000; },
     "shapes of remnants are a sketch (b/a too large by 0.1 and more); use 5000"},
    {"material.drucker_prager.cohesion_Pa",
     [](const Scene& s) { return s.material.drucker_prager.cohesion_Pa; },
     [](const Scene& s) {
       return s.material.drucker_prager.cohesion_Pa > 0.01 * s.material.shear_modulus_Pa;
     },
     "matter bends by percents before it yields and rebounds like rubber; raise "
     "material.shear_modulus_Pa, tillotson.A_Pa and B_Pa in proportion to a hundred times the "
     "cohesion or more"},
    {"impactor.material.cohesion_Pa",
     [](const Scene& s) { return impactor_material(s).drucker_prager.cohesion_Pa; },
     [](const Scene& s) {
       const double own = s.impactor.material.cohesion_Pa.value_or(0);
       return own > 0.01 * s.material.shear_modulus_Pa;
     },
     "matter bends by percents before it yields and rebounds like rubber; raise the moduli in "
     "proportion to a hundred times the cohesion or more"},
    {"environment.primary.distance_m",
     [](const Scene& s) { return s.environment.primary.distance_m; },
     [](const Scene& s) { return hill_radius(s) < contact_distance(s); },
     "bodies that touch reach beyond their Hill radius, so the tide pulls them apart; give more"},
    {"impact.v_imp_cm_per_s", [](const Scene& s) { return s.impact.v_imp_cm_per_s; },
     [](const Scene& s) {
       return s.material.eos != "ideal-gas" &&
              s.impact.v_imp_cm_per_s / 100 > 0.2 * bulk_sound_speed(s);
     },
     "more than a fifth of the sound speed of the material, so that it is compressed by percents; "
     "raise the elastic moduli"},
};

}  // namespace

std::vector<std::string> warnings(const Scene& scene) {
  std::vector<std::string> found;
  for (const Guard& guard : guards)
    if (guard.crossed(scene))
      found.push_back(
          fmt::format("scene.{} = {:g}: {}", guard.field, guard.value(scene), guard.consequence));
  if (!scene.numerics.gradient.starts_with("corrected") ||
      scene.numerics.gradient == "corrected-rate")
    found.push_back(fmt::format(
        "scene.numerics.gradient = \"{}\": angular momentum is lost by {} over an impact; use "
        "\"corrected\"",
        scene.numerics.gradient,
        scene.numerics.gradient == "plain" ? "tens of percents" : "percents"));
  return found;
}

}  // namespace eerie
