#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "solver/scene/scene.hpp"

namespace eerie {

// An impactor may be of other density, friction and cohesion than the target. Elastic moduli and
// all laws are those of both, and so is the mass of a particle: one of less dense matter is larger,
// and so is its smoothing length.

/// scene.material with what the impactor has of its own.
Scene::Material impactor_material(const Scene& scene);

double impactor_density(const Scene& scene);  ///< without pressure, kg/m^3
bool has_two_materials(const Scene& scene);
bool has_two_densities(const Scene& scene);

/// The lower and the higher one of the reference densities of both bodies, kg/m^3.
double lowest_density(const Scene& scene);
double highest_density(const Scene& scene);

/// Sizes of the particles of target and impactor, in units of the larger ones.
std::array<double, 2> particle_sizes(const Scene& scene);

/// Takes out of a scene written as JSON what its impactor shares with the target.
void leave_out_shared_material(nlohmann::json& scene);

/// Throws InputError where two materials ask for what the solver does not have.
void require_fitting_materials(const Scene& scene, const std::string& where);

}  // namespace eerie
