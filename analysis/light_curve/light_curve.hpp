#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/shapes/shape.hpp"

namespace eerie::light_curve {

/// The largest amplitude of 1I/'Oumuamua, mag (Meech et al. 2017, Nature 552, 378).
inline constexpr double oumuamua_amplitude_mag = 2.5;

/// The number of directions per rotation.
inline constexpr std::size_t light_curve_phases = 120;

/// A body that spins about its shortest principal axis, seen from afar with the Sun behind the
/// observer (phase angle 0). Its brightness is proportional to its shadow, since every piece of a
/// uniform surface is equally bright at any inclination. The law of Lommel and Seeliger says so at
/// phase angle 0. By Lambert's law limbs would be darker.
struct SpinningBody {
  std::vector<Vec3> x;  ///< of the particles along the principal axes a, b, c, m
  double radius = 0;    ///< of a particle, m
  shapes::Shape shape;  ///< ellipsoid of inertia
};

/// Makes the body of these points. Throws InputError for points without a volume, which have no
/// axes.
SpinningBody spinning_body(std::span<const Vec3> x, double radius);

/// The direction to the observer, along a, b, c. `aspect` is its angle to the spin axis c, rad.
/// `phase` is that of the rotation, rad; at 0 the longest axis points towards the observer as
/// nearly as it can.
Vec3 line_of_sight(double aspect, double phase);

/// The shadow of an ellipsoid along a unit vector n in its principal axes, m^2: pi sqrt((B C n_a)^2
/// + (A C n_b)^2 + (A B n_c)^2), where A, B, C are half of shape.a, b, c (Connelly & Ostro 1984).
double ellipsoid_shadow(const shapes::Shape& shape, const Vec3& along);

/// The amplitude of an ellipsoid in closed form, mag: 1.25 log10 of the ratio of the squared
/// shadows at phases of 90 and 0 degrees. Seen equator-on it is 2.5 log10(a/b).
double ellipsoid_amplitude(const shapes::Shape& shape, double aspect);

/// The light curve of one rotation.
struct LightCurve {
  double aspect = 0;              ///< rad
  std::vector<double> phase;      ///< rad
  std::vector<double> particles;  ///< shadow of the particles, m^2
  std::vector<double> ellipsoid;  ///< shadow of the ellipsoid of inertia, m^2
};
LightCurve light_curve(const SpinningBody& body, double aspect,
                       std::size_t phases = light_curve_phases);

/// The amplitude 2.5 log10(brightest/faintest), mag.
double amplitude(std::span<const double> brightness);

/// The amplitudes of a body at one aspect, mag.
struct AspectAmplitude {
  double aspect = 0;  ///< rad
  double particles = 0, ellipsoid = 0;
};
/// The amplitudes from pole-on (0) to equator-on (pi/2), both included, in even steps. `count` is
/// at least 2.
std::vector<AspectAmplitude> amplitudes_over_aspect(const SpinningBody& body,
                                                    std::size_t count = 31);

/// CSV tables with units in their first line.
std::string light_curve_csv(const LightCurve& curve);
std::string amplitudes_csv(std::span<const AspectAmplitude> amplitudes);

/// Magnitudes relative to the brightest value.
double magnitude_of(double brightness, double brightest);

}  // namespace eerie::light_curve
