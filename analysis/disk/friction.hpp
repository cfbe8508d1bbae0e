#pragma once

namespace eerie::disk {

/// The friction coefficient mu_d = tan(phi_d), with phi_d in rad.
double friction_coefficient(double phi_d);

/// The energy that friction dissipates, J, while fragments move by `displacement` (m) over the
/// surface of a remnant of mean radius `radius` (m): pi R^2 L mu_d p_c, Eq. (3) of Sugiura et al.
/// (2019).
double dissipated_energy(double radius, double density, double displacement, double mu_d);

/// The energy of fragments that gather into a sphere, J: M v_esc^2 / 2, Eq. (4) of Sugiura et al.
/// (2019).
double gathering_energy(double radius, double density);

/// The distance L/R_r over which friction lets fragments slide. It is 1/mu_d to an order of
/// magnitude, Eq. (5) of Sugiura et al. (2019).
double displacement_over_radius(double mu_d);

/// L/R_r with the factor that Eqs. (3) and (4) give for a sphere: 8 / (3 mu_d).
double displacement_over_radius_of_sphere(double mu_d);

}  // namespace eerie::disk
