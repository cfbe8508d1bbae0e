#include "analysis/light_curve/light_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/light_curve/shadow.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"

namespace eerie::light_curve {

namespace {

/// Rows in the radius of a particle: so many that a body of 2,000 particles is as finely cut as by
/// shadow_pixels_per_radius, and larger ones no finer.
double fineness(std::size_t particles) {
  return std::clamp(shadow_pixels_per_radius * std::cbrt(2000 / static_cast<double>(particles)),
                    3.0, shadow_pixels_per_radius);
}

}  // namespace

SpinningBody spinning_body(std::span<const Vec3> x, double radius) {
  SpinningBody body{{}, radius, shapes::ellipsoid_of_inertia(x)};
  if (!body.shape.degenerate.empty())
    throw InputError("it has no light curve: " + body.shape.degenerate);
  Vec3 centre;
  for (const Vec3& p : x) centre += p;
  centre = centre / static_cast<double>(x.size());
  const auto& [along_a, along_b, along_c] = body.shape.axes;
  for (const Vec3& p : x) {
    const Vec3 off = p - centre;
    body.x.push_back({dot(off, along_a), dot(off, along_b), dot(off, along_c)});
  }
  return body;
}

Vec3 line_of_sight(double aspect, double phase) {
  return {std::sin(aspect) * std::cos(phase), std::sin(aspect) * std::sin(phase), std::cos(aspect)};
}

double ellipsoid_shadow(const shapes::Shape& shape, const Vec3& along) {
  const double a = shape.a / 2, b = shape.b / 2, c = shape.c / 2;
  return pi * norm(Vec3{b * c * along.x, a * c * along.y, a * b * along.z});
}

double ellipsoid_amplitude(const shapes::Shape& shape, double aspect) {
  return 2.5 * std::log10(ellipsoid_shadow(shape, line_of_sight(aspect, pi / 2)) /
                          ellipsoid_shadow(shape, line_of_sight(aspect, 0)));
}

LightCurve light_curve(const SpinningBody& body, double aspect, std::size_t phases) {
  LightCurve curve{aspect, std::vector<double>(phases), std::vector<double>(phases),
                   std::vector<double>(phases)};
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < phases; ++k) {
    const double phase = 2 * pi * static_cast<double>(k) / static_cast<double>(phases);
    const Vec3 along = line_of_sight(aspect, phase);
    curve.phase[k] = phase;
    curve.particles[k] = shadow_area(body.x, body.radius, along, fineness(body.x.size()));
    curve.ellipsoid[k] = ellipsoid_shadow(body.shape, along);
  }
  return curve;
}

double amplitude(std::span<const double> brightness) {
  const auto [faintest, brightest] = std::ranges::minmax(brightness);
  return 2.5 * std::log10(brightest / faintest);
}

std::vector<AspectAmplitude> amplitudes_over_aspect(const SpinningBody& body, std::size_t count) {
  std::vector<AspectAmplitude> found;
  for (std::size_t k = 0; k < count; ++k) {
    const double aspect = pi / 2 * static_cast<double>(k) / static_cast<double>(count - 1);
    found.push_back({aspect, amplitude(light_curve(body, aspect).particles),
                     ellipsoid_amplitude(body.shape, aspect)});
  }
  return found;
}

double magnitude_of(double brightness, double brightest) {
  return -2.5 * std::log10(brightness / brightest);
}

std::string light_curve_csv(const LightCurve& curve) {
  const double brightest = std::ranges::max(curve.particles);
  const double brightest_ellipsoid = std::ranges::max(curve.ellipsoid);
  std::string text =
      "rotation_phase_deg,particles_area_m2,particles_mag,ellipsoid_area_m2,ellipsoid_mag\n";
  for (std::size_t k = 0; k < curve.phase.size(); ++k)
    text += fmt::format("{:.6g},{:.6g},{:.4f},{:.6g},{:.4f}\n", degrees(curve.phase[k]),
                        curve.particles[k], std::abs(magnitude_of(curve.particles[k], brightest)),
                        curve.ellipsoid[k],
                        std::abs(magnitude_of(curve.ellipsoid[k], brightest_ellipsoid)));
  return text;
}

std::string amplitudes_csv(std::span<const AspectAmplitude> amplitudes) {
  std::string text = "aspect_deg,particles_amplitude_mag,ellipsoid_amplitude_mag\n";
  for (const AspectAmplitude& a : amplitudes)
    text += fmt::format("{:.6g},{:.4f},{:.4f}\n", degrees(a.aspect), a.particles,
                        std::abs(a.ellipsoid));
  return text;
}

}  // namespace eerie::light_curve
