#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/shapes/shape.hpp"

namespace eerie::light_curve {

/// Largest amplitude of 1I/'Oumuamua, mag (Meech et al. 2017, Nature 552, 378).
inline constexpr double oumuamua_amplitude_mag = 2.5;

/// Directions per rotation.
inline constexpr std::size_t light_curve_phases = 120;

/// A body that spins about its shortest principal axis, seen from afar with the Sun behind the
/// observer (phase angle 0). Its brightness is its shadow: what a uniform surface gives whose
/// pieces are equally bright however they are inclined. By the law of Lommel and Seeliger that
/// is so at phase angle 0; by Lambert's, limbs would be darker.
struct SpinningBody {
  std::vector<Vec3> x;  ///< of the particles, m, along the principal axes a, b, c
  double radius = 0;    ///< of a particle, m
  shapes::Shape shape;  ///< ellipsoid of inertia
};

/// Throws InputError for points without a volume, which have no axes to turn about.
SpinningBody spinning_body(std::span<const Vec3> x, double radius);

/// Towards the observer, along a, b, c. `aspect`: angle to the spin axis c, rad; `phase`: of the
/// rotation, rad, 0 where the longest axis points to the observer as nearly as it can.
Vec3 line_of_sight(double aspect, double phase);

/// Shadow of an ellipsoid along a unit vector in its principal axes, m^2: pi sqrt(sum of (B C
/// n_a)^2 and its like), A, B, C half of shape.a, b, c (e.g. Connelly & Ostro 1984).
double ellipsoid_shadow(const shapes::Shape& shape, const Vec3& along);

/// Its amplitude in closed form, mag: 1.25 log10 of the ratio of the squared shadows at phases of
/// 90 and 0 degrees; 2.5 log10(a/b) seen equator-on.
double ellipsoid_amplitude(const shapes::Shape& shape, double aspect);

/// One rotation.
struct LightCurve {
  double aspect = 0;              ///< rad
  std::vector<double> phase;      ///< rad
  std::vector<double> particles;  ///< shadow of the particles, m^2
  std::vector<double> ellipsoid;  ///< shadow of the ellipsoid of inertia, m^2
};
LightCurve light_curve(const SpinningBody& body, double aspect,
                       std::size_t phases = light_curve_phases);

/// 2.5 log10(brightest/faintest), mag.
double amplitude(std::span<const double> brightness);

/// Amplitudes of one body over the aspect, mag.
struct AspectAmplitude {
  double aspect = 0;  ///< rad
  double particles = 0, ellipsoid = 0;
};
/// From pole-on (0) to equator-on (pi/2) in even steps, both included; `count` of at least 2.
std::vector<AspectAmplitude> amplitudes_over_aspect(const SpinningBody& body,
                                                    std::size_t count = 31);

/// Tables with units in their first line.
std::string light_curve_csv(const LightCurve& curve);
std::string amplitudes_csv(std::span<const AspectAmplitude> amplitudes);

/// Magnitudes by which something is fainter than the brightest.
double magnitude_of(double brightness, double brightest);

}  // namespace eerie::light_curve
