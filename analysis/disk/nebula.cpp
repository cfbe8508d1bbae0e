#include "analysis/disk/nebula.hpp"

#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie::disk {

namespace {

constexpr double boltzmann = 1.380649e-23;           // J/K
constexpr double atomic_mass_unit = 1.66053907e-27;  // kg
constexpr double molecule = hayashi.mean_molecular_weight * atomic_mass_unit;
/// -dlnP/dlnr in the midplane: P = rho c^2, rho falls as r^(-11/4), c^2 as r^(-1/2).
constexpr double pressure_slope = 13.0 / 4;

}  // namespace

Nebula hayashi_nebula(double r) {
  const double au = r / astronomical_unit, surface = std::pow(au, -1.5);
  Nebula n;
  n.r = r;
  n.gas_surface_density = hayashi.gas_at_1_au * surface;
  n.solid_surface_density =
      (au < hayashi.snow_line_au ? hayashi.rock_at_1_au : hayashi.rock_and_ice_at_1_au) * surface;
  n.temperature = hayashi.temperature_at_1_au / std::sqrt(au);
  n.sound_speed = std::sqrt(boltzmann * n.temperature / molecule);
  n.omega_k = std::sqrt(solar_gm / cubed(r));
  n.gas_density = n.gas_surface_density / (std::sqrt(2 * pi) * n.scale_height());
  n.mean_free_path = molecule / (molecule_cross_section * n.gas_density);
  n.thermal_speed = std::sqrt(8 / pi) * n.sound_speed;
  // Adachi, Hayashi & Nakazawa (1976), Prog. Theor. Phys. 56, 1756: v_K - v_gas.
  n.head_wind = pressure_slope / 2 * n.sound_speed * n.sound_speed / n.keplerian_speed();
  return n;
}

}  // namespace eerie::disk
