#pragma once

namespace eerie::disk {

inline constexpr double astronomical_unit = 1.495978707e11;  ///< m (IAU 2012)
inline constexpr double solar_gm = 1.32712440018e20;         ///< G times the Sun's mass, m^3 s^-2

/// The constants of the minimum mass solar nebula (Hayashi 1981, Prog. Theor. Phys. Suppl. 70, 35).
/// He gives surface densities in g/cm^2; 1 g/cm^2 = 10 kg/m^2. All surface densities fall as
/// r^(-3/2), the temperature as r^(-1/2).
struct HayashiConstants {
  double gas_at_1_au = 1.7e4;           ///< kg/m^2
  double rock_at_1_au = 71;             ///< solids inside the snow line, kg/m^2
  double rock_and_ice_at_1_au = 300;    ///< solids outside the snow line, kg/m^2
  double snow_line_au = 2.7;            ///< the distance at which the temperature is 170 K
  double temperature_at_1_au = 280;     ///< K, for the luminosity of the Sun
  double mean_molecular_weight = 2.34;  ///< in atomic mass units
};
inline constexpr HayashiConstants hayashi;

/// The collisional cross-section of a hydrogen molecule, m^2 (Nakagawa, Sekiya & Hayashi 1986,
/// Icarus 67, 375).
inline constexpr double molecule_cross_section = 2e-19;

/// The midplane of the nebula at one distance from the star, in SI.
struct Nebula {
  double r = 0;                      ///< m
  double gas_surface_density = 0;    ///< kg/m^2
  double solid_surface_density = 0;  ///< kg/m^2; steps up at the snow line, which counts as outside
  double temperature = 0;            ///< K
  double sound_speed = 0;            ///< isothermal, m/s
  double omega_k = 0;                ///< Keplerian angular frequency, 1/s
  double gas_density = 0;            ///< kg/m^3, of a vertically isothermal disk
  double mean_free_path = 0;         ///< of a molecule, m
  double thermal_speed = 0;          ///< mean speed of a molecule, m/s
  double head_wind = 0;              ///< Keplerian speed minus that of the gas, m/s

  double keplerian_speed() const { return r * omega_k; }
  double scale_height() const { return sound_speed / omega_k; }  ///< H in exp(-z^2 / 2 H^2), m
};

/// The nebula at the distance `r` > 0, m. Hayashi's own range is 0.35 to 36 AU; the power laws
/// continue beyond it.
Nebula hayashi_nebula(double r);

}  // namespace eerie::disk
