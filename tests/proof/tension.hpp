#pragma once

namespace eerie::proof {

/// A cube of intact basalt (Benz & Asphaug 1999: Weibull m = 9, k = 4e35 per m^3) that is pulled
/// apart evenly, v = rate x, so fast that its middle breaks before it hears of its free faces.
struct Pull {
  double rate;     ///< 1/s, of each direction
  double spacing;  ///< of the particles, m
  int across;      ///< particles over an eighth of the cube, which slip walls complete
};

struct Strength {
  double peak;     ///< of the mean tension in the middle, Pa
  double active;   ///< flaws per particle that the strain then activates
  double release;  ///< how far the faces have been heard by then, in spacings
};
Strength pull(const Pull& pull);

/// The same for particles that share the strain but nothing else, with flaws dealt alike.
double peak_without_inertia(const Pull& pull);

/// The same with a continuous number of flaws: D^(1/3) = c_g (4 pi k/3)^(1/3) s^(m/3) t^(m/3 + 1)
/// /(m/3 + 1), tension E s t (1 - D) with s = 3 K rate/E. Its maximum, at D = 1/(m + 4), is
/// proportional to rate^(3/(m + 3)) and knows no particles.
double peak_of_continuum(double rate);
/// Spacing with which three flaws per particle are active at that maximum.
double matching_spacing(double rate);
/// Tension that activates the weakest flaw of a cube with `particles` of one spacing, Pa.
double weakest_flaw(double spacing, double particles);

}  // namespace eerie::proof
