#pragma once

namespace eerie::proof {

/// An elastic plate, L = 0.2 m long and H = 0.02 m thick, in plane strain (E 2 MPa, rho 1000
/// kg/m^3, nu 0.3975), in its gravest bending oscillation: clamped at one end (a rough wall), or
/// free (half of it, with its middle on a slip wall).
enum class Support { clamped, free };

/// Period of thin-plate theory, s: 2 pi/(k^2 H) sqrt(12 rho (1 - nu^2)/E), k L = 1.8751 or 4.7300
/// (Landau & Lifshitz 1986, sec. 25).
double thin_plate_period(Support support);
/// The share that shear and rotary inertia add to that period, to first order in (H/L)^2.
double thickness_correction(Support support);

/// Measured between two zero crossings; `layers`: particles over H.
struct Oscillation {
  double period;   ///< s
  double z_drift;  ///< largest displacement in the direction without strain, in spacings
};
Oscillation plate_oscillation(Support support, int layers, double artificial_stress = 0.3);

}  // namespace eerie::proof
