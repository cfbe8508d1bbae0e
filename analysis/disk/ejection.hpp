#pragma once

namespace eerie::disk {

/// The Hill radius, m, of a planet on a circle of radius `distance` (m). `mass_ratio` is planet
/// over star.
double hill_radius(double distance, double mass_ratio);

/// The radius of the smallest stable circle around both stars of a binary, in units of their
/// separation (Holman & Wiegert 1999, AJ 117, 621, Eq. 3). `mass_fraction` is that of the lighter
/// star, 0.1 to 0.5; `eccentricity` is 0 to 0.7.
double circumbinary_limit(double mass_fraction, double eccentricity);

}  // namespace eerie::disk
