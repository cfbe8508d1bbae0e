#include "analysis/disk/friction.hpp"

#include <cmath>

#include "analysis/disk/encounter_speed.hpp"
#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"

namespace eerie::disk {

double friction_coefficient(double phi_d) { return std::tan(phi_d); }

double dissipated_energy(double radius, double density, double displacement, double mu_d) {
  return pi * radius * radius * displacement * mu_d * central_pressure({radius, density});
}

double gathering_energy(double radius, double density) {
  const double v_esc = escape_speed({radius, density});
  return 0.5 * density * sphere_volume(radius) * v_esc * v_esc;
}

double displacement_over_radius(double mu_d) { return 1 / mu_d; }

double displacement_over_radius_of_sphere(double mu_d) { return 8 / (3 * mu_d); }

}  // namespace eerie::disk
