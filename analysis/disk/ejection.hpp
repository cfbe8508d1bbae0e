#pragma once

namespace eerie::disk {

/// Hill radius, m, of a planet of `mass_ratio` to its star on a circle of radius `distance` (m).
double hill_radius(double distance, double mass_ratio);

/// The smallest stable circle around both stars of a binary, in units of their separation; Holman &
/// Wiegert (1999), AJ 117, 621, Eq. (3). `mass_fraction` of the lighter star in both: 0.1 to 0.5;
/// eccentricity 0 to 0.7.
double circumbinary_limit(double mass_fraction, double eccentricity);

}  // namespace eerie::disk
