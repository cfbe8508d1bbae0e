#include "solver/scene/two_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"

namespace eerie {

namespace {

/// Largest ratio of densities, which the proofs cover.
constexpr double most_contrast = 27.0 / 8;

bool has_two_strengths(const Scene& scene) {
  const Scene::DruckerPrager& target = scene.material.drucker_prager;
  const Scene::Impactor::Material& own = scene.impactor.material;
  return own.phi_d_deg.value_or(target.phi_d_deg) != target.phi_d_deg ||
         own.cohesion_Pa.value_or(target.cohesion_Pa) != target.cohesion_Pa;
}

}  // namespace

Scene::Material impactor_material(const Scene& scene) {
  const Scene::Impactor::Material& own = scene.impactor.material;
  Scene::Material m = scene.material;
  m.rho0_kg_per_m3 = impactor_density(scene);
  m.drucker_prager.phi_d_deg = own.phi_d_deg.value_or(m.drucker_prager.phi_d_deg);
  m.drucker_prager.cohesion_Pa = own.cohesion_Pa.value_or(m.drucker_prager.cohesion_Pa);
  return m;
}

double impactor_density(const Scene& scene) {
  return scene.impactor.material.rho0_kg_per_m3.value_or(scene.material.rho0_kg_per_m3);
}

bool has_two_densities(const Scene& scene) {
  return lowest_density(scene) != highest_density(scene);
}

bool has_two_materials(const Scene& scene) {
  return has_two_densities(scene) || has_two_strengths(scene);
}

double lowest_density(const Scene& scene) {
  return std::min(scene.material.rho0_kg_per_m3, impactor_density(scene));
}

double highest_density(const Scene& scene) {
  return std::max(scene.material.rho0_kg_per_m3, impactor_density(scene));
}

std::array<double, 2> particle_sizes(const Scene& scene) {
  const double low = lowest_density(scene);
  return {std::cbrt(low / scene.material.rho0_kg_per_m3), std::cbrt(low / impactor_density(scene))};
}

void leave_out_shared_material(nlohmann::json& scene) {
  if (!scene["impactor"].contains("material")) return;
  nlohmann::json &own = scene["impactor"]["material"], &target = scene["material"];
  const auto leave_out = [&](const char* field, const nlohmann::json& shared) {
    if (own.contains(field) && own[field] == shared) own.erase(field);
  };
  leave_out("rho0_kg_per_m3", target["rho0_kg_per_m3"]);
  leave_out("phi_d_deg", target["drucker_prager"]["phi_d_deg"]);
  leave_out("cohesion_Pa", target["drucker_prager"]["cohesion_Pa"]);
  if (own.empty()) scene["impactor"].erase("material");
}

void require_fitting_materials(const Scene& scene, const std::string& where) {
  if (!has_two_materials(scene)) return;
  const Scene::Material& m = scene.material;
  if (m.eos == "ideal-gas" || m.fracture != "none")
    throw InputError(fmt::format(
        "{}.impactor.material: a material of its own is for rubble; leave it out, or set "
        "material.eos to \"tillotson\" or \"linear\" and material.fracture to \"none\"",
        where));
  if (has_two_strengths(scene) && m.rheology != "drucker-prager")
    throw InputError(fmt::format(
        "{}.impactor.material: friction and cohesion do nothing in material of rheology \"{}\"; "
        "leave phi_d_deg and cohesion_Pa out, or set material.rheology to \"drucker-prager\"",
        where, m.rheology));
  if (!has_two_densities(scene)) return;
  const double rho = impactor_density(scene), target = m.rho0_kg_per_m3;
  if (highest_density(scene) > most_contrast * lowest_density(scene))
    throw InputError(fmt::format(
        "{}.impactor.material.rho0_kg_per_m3 = {:g}: particles of both bodies have one mass, and "
        "their sizes may not differ more; give {:g} to {:g}, for material.rho0_kg_per_m3 = {:g}",
        where, rho, target / most_contrast, target * most_contrast, target));
  if (scene.numerics.artificial_stress > 0)
    throw InputError(fmt::format(
        "{}.numerics.artificial_stress = {:g}: it knows one spacing of particles; set it to 0, or "
        "give both bodies one density",
        where, scene.numerics.artificial_stress));
  if (!scene.target.remnant.file.empty())
    throw InputError(where +
                     ".impactor.material.rho0_kg_per_m3: particles of a remnant keep their "
                     "smoothing length; give the impactor its density");
}

}  // namespace eerie
