#include "solver/scene/usable.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/base/bodies/two_bodies.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/body_shape.hpp"
#include "solver/scene/tide.hpp"
#include "solver/scene/two_materials.hpp"

namespace eerie {

namespace {

void require_shape(const Scene::Shape& shape, const std::string& field) {
  if (shape.c_over_a <= shape.b_over_a) return;
  throw InputError(
      fmt::format("{}.c_over_a = {:g}: must be at most b_over_a = {:g}; exchange the two, c is the "
                  "shortest axis",
                  field, shape.c_over_a, shape.b_over_a));
}

void require_whole_remnant(const Scene::Target& target, const std::string& field) {
  const Scene::Remnant& from = target.remnant;
  if (from.file.empty() && from.sha256.empty()) return;
  if (from.file.empty() || from.sha256.size() != 64)
    throw InputError(fmt::format(
        "{}.remnant: file and sha256 go together; `eerie remnant` prints both, and what else the "
        "scene needs",
        field));
  if (target.spin.period_h != 0)
    throw InputError(fmt::format("{}.spin.period_h = {:g}: a remnant spins as it did; set it to 0",
                                 field, target.spin.period_h));
}

/// What no single field's range can say.
void require_consistent(const Scene& scene, const std::string& where) {
  const Scene::Material& m = scene.material;
  if (m.eos == "ideal-gas" && m.energy != "integrated")
    throw InputError(where +
                     ".material.energy = \"none\": the pressure of an ideal gas is its heat; "
                     "set material.energy to \"integrated\"");
  if (m.fracture != "none" && m.rheology != "lundborg")
    throw InputError(
        fmt::format("{}.material.fracture = \"{}\": material of rheology \"{}\" cannot break; set "
                    "material.rheology to \"lundborg\" or material.fracture to \"none\"",
                    where, m.fracture, m.rheology));
  if (m.rheology == "lundborg" && m.lundborg.Y_M_Pa <= m.lundborg.Y_0_Pa)
    throw InputError(
        fmt::format("{}.material.lundborg.Y_M_Pa = {:g}: must be greater than Y_0_Pa = {:g}", where,
                    m.lundborg.Y_M_Pa, m.lundborg.Y_0_Pa));
  if (scene.numerics.late_sound_speed < 1 && scene.end.settled.window_s == 0)
    throw InputError(
        fmt::format("{}.numerics.late_sound_speed = {:g}: when the late phase begins is asked as "
                    "often as the settled stop looks; set end.settled.window_s too, to 4000 for "
                    "instance",
                    where, scene.numerics.late_sound_speed));
  if (scene.numerics.void_density > 0 && scene.numerics.voids == "all" &&
      scene.numerics.smoothing != "constant")
    throw InputError(fmt::format(
        "{}.numerics.void_density = {:g}: voids are seen with one smoothing length for all; set it "
        "to 0, numerics.voids to \"gaps\" or numerics.smoothing to \"constant\"",
        where, scene.numerics.void_density));
  if (scene.numerics.late_sound_speed < 1 && m.energy != "none")
    throw InputError(fmt::format(
        "{}.numerics.late_sound_speed = {:g}: a late phase keeps no energy budget; set it to 1, or "
        "material.energy to \"none\"",
        where, scene.numerics.late_sound_speed));
  if (scene.numerics.rigid_flight && scene.end.settled.window_s == 0)
    throw InputError(fmt::format(
        "{}.numerics.rigid_flight = true: whether remnants may fly is asked as often as "
        "the settled stop looks; set end.settled.window_s too, to 4000 for instance",
        where));
  if (scene.numerics.rigid_flight && m.energy != "none")
    throw InputError(
        fmt::format("{}.numerics.rigid_flight = true: what lands in a flight keeps no energy "
                    "budget; set it to false, or material.energy to \"none\"",
                    where));
  require_shape(scene.target.shape, where + ".target.shape");
  require_shape(scene.impactor.shape, where + ".impactor.shape");
  require_whole_remnant(scene.target, where + ".target");
  require_standing(scene, where);
  require_fitting_materials(scene, where);
  const std::vector<Scene::Wall>& walls = scene.environment.walls;
  for (std::size_t a = 0; a < walls.size(); ++a)
    for (std::size_t b = a + 1; b < walls.size(); ++b) {
      if (walls[a].face == walls[b].face)
        throw InputError(
            fmt::format("{}.environment.walls[{}].face = \"{}\": there is such a wall "
                        "already; give each face at most one",
                        where, b, walls[b].face));
      if (walls[a].face[0] != walls[b].face[0]) continue;
      const bool a_low = walls[a].face.ends_with("_low");
      const Scene::Wall &low = a_low ? walls[a] : walls[b], &high = a_low ? walls[b] : walls[a];
      if (low.at_m >= high.at_m)
        throw InputError(
            fmt::format("{}.environment.walls: {} at {:g} m is not below {} at {:g} m; "
                        "exchange their at_m",
                        where, low.face, low.at_m, high.face, high.at_m));
    }
}

/// The bodies start apart, on the orbit that leads to the impact.
void require_orbit(const Scene& scene, const std::string& where) {
  const double start = contact_distance(scene) * scene.impact.separation;
  const Contact contact = contact_of(
      {scene.target.radius_m, scene.material.rho0_kg_per_m3}, impactor_radius(scene),
      scene.impact.q, scene.impact.v_imp_cm_per_s / 100, radians(scene.impact.theta_imp_deg));
  const double longest = scene.target.radius_m * target_shape(scene).semi_axes().x +
                         impactor_radius(scene) * impactor_shape(scene).semi_axes().x;
  if (start < longest)
    throw InputError(fmt::format(
        "{}.impact.separation = {:g}: ellipsoids of {:.4g} m in all may touch as they start; give "
        "{:.3g} or more",
        where, scene.impact.separation, longest, 1.05 * longest / contact_distance(scene)));
  if (radial_speed2(contact, start) >= 0) return;
  throw InputError(fmt::format(
      "{}.impact.v_imp_cm_per_s = {:g}: bodies of {:g} m that touch at {:g} deg were never {:.4g} "
      "m "
      "apart, as they start; give {:.4g} cm/s or more, or lower impact.separation = {:g}",
      where, scene.impact.v_imp_cm_per_s, scene.target.radius_m, scene.impact.theta_imp_deg, start,
      100 * least_contact_speed(contact, start) * 1.001, scene.impact.separation));
}

}  // namespace

void require_usable(const Scene& scene, const std::string& where) {
  require_consistent(scene, where);
  require_orbit(scene, where);
  require_primary(scene, where);
  if (impactor_particles(scene) < 100)
    throw TooFewParticles(fmt::format(
        "{}.impact.q = {}: the impactor would have {} particles and needs at least 100; "
        "raise numerics.particles_per_target to {} or more, or raise q",
        where, scene.impact.q, impactor_particles(scene),
        static_cast<std::int64_t>(std::ceil(100 / scene.impact.q))));
}

}  // namespace eerie
