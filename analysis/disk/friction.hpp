#pragma once

namespace eerie::disk {

/// mu_d = tan(phi_d), phi_d in rad.
double friction_coefficient(double phi_d);

/// What friction takes while fragments move by `displacement` (m) over the surface of a remnant of
/// mean radius `radius` (m), J: pi R^2 L mu_d p_c, Sugiura et al. (2019), Eq. (3).
double dissipated_energy(double radius, double density, double displacement, double mu_d);

/// What fragments bring that gather to a sphere, J: M v_esc^2 / 2, Sugiura et al. (2019), Eq. (4).
double gathering_energy(double radius, double density);

/// L/R_r, how far friction lets fragments slide: 1/mu_d as Sugiura et al. (2019), Eq. (5), have it
/// to an order of magnitude.
double displacement_over_radius(double mu_d);

/// L/R_r with the factor that their Eqs. (3) and (4) give for a sphere: 8 / (3 mu_d).
double displacement_over_radius_of_sphere(double mu_d);

}  // namespace eerie::disk
