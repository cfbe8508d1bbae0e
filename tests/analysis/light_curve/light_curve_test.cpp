#include "analysis/light_curve/light_curve.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "analysis/light_curve/light_curve_figure.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/analysis/remnants/bodies.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::light_curve {
namespace {
using testing::HasSubstr;

constexpr double lattice = 2.5;  // m
const double radius = std::cbrt(3 / (4 * pi)) * lattice;

/// Particles inside an ellipsoid along x, y, z, on a lattice that is askew to it: along its own
/// axes a lattice lets light through.
std::vector<Vec3> askew(const Vec3& half) {
  const double reach = std::max({half.x, half.y, half.z});
  std::vector<Vec3> inside;
  for (const Vec3& p : test::moved(test::ellipsoid({reach, reach, reach}, lattice),
                                   test::rotation({1, 0.6, -0.3}, 0.7), {}))
    if (norm2({p.x / half.x, p.y / half.y, p.z / half.z}) <= 1) inside.push_back(p);
  return inside;
}

/// The same as a body, turned and moved somewhere.
SpinningBody lattice_body(const Vec3& half) {
  return spinning_body(test::moved(askew(half), test::rotation({1, 2, -1}, 0.8), {5e3, -100, 7}),
                       radius);
}

shapes::Shape shape_of(double a, double b, double c) {
  shapes::Shape shape;
  shape.a = a, shape.b = b, shape.c = c;
  return shape;
}

TEST(LightCurve, SphereDoesNotVary) {
  const SpinningBody ball = lattice_body({50, 50, 50});
  // The outline is one of discs, some in front of it by a particle and some behind: 2 r/R at most.
  for (const double aspect : {0.3, pi / 2})
    EXPECT_LT(amplitude(light_curve(ball, aspect).particles), 0.025);
  const double shadow = light_curve(ball, 1).particles[0];
  EXPECT_GT(shadow, pi * 50 * 50);
  EXPECT_LT(shadow, pi * std::pow(50 + radius, 2));
}

TEST(LightCurve, EquatorOnAnEllipsoidVariesByTheRatioOfItsAxes) {
  // Of its axes as its discs draw them: the outermost particles lie in the surface.
  EXPECT_NEAR(amplitude(light_curve(lattice_body({100, 50, 40}), pi / 2).particles),
              2.5 * std::log10((100 + radius) / (50 + radius)), 0.01);
  EXPECT_NEAR(ellipsoid_amplitude(shape_of(200, 100, 80), pi / 2), 2.5 * std::log10(2), 1e-12);
}

/// 1.25 log10 ((a^2 c^2 s^2 + a^2 b^2 k^2)/(b^2 c^2 s^2 + a^2 b^2 k^2)), s and k: sine and cosine
/// of the aspect; half axes.
double triaxial_amplitude(double a, double b, double c, double aspect) {
  const double s = std::sin(aspect), k = std::cos(aspect);
  const double pole = std::pow(a * b * k, 2);
  return 1.25 * std::log10((std::pow(a * c * s, 2) + pole) / (std::pow(b * c * s, 2) + pole));
}

TEST(LightCurve, AmplitudeOverAspectIsThatOfTheTriaxialEllipsoid) {
  for (const AspectAmplitude& seen : amplitudes_over_aspect(lattice_body({100, 50, 40}), 4)) {
    EXPECT_NEAR(seen.particles,
                triaxial_amplitude(100 + radius, 50 + radius, 40 + radius, seen.aspect), 0.015)
        << seen.aspect;
    EXPECT_NEAR(ellipsoid_amplitude(shape_of(200, 100, 80), seen.aspect),
                triaxial_amplitude(100, 50, 40, seen.aspect), 1e-12);
    EXPECT_NEAR(seen.ellipsoid, triaxial_amplitude(100, 50, 40, seen.aspect), 0.005);
  }
}

TEST(LightCurve, ShadowsOfAnEllipsoidAlongItsAxesAreEllipses) {
  const shapes::Shape shape = shape_of(20, 12, 8);
  EXPECT_NEAR(ellipsoid_shadow(shape, {1, 0, 0}), pi * 6 * 4, 1e-9);
  EXPECT_NEAR(ellipsoid_shadow(shape, {0, 1, 0}), pi * 10 * 4, 1e-9);
  EXPECT_NEAR(ellipsoid_shadow(shape, {0, 0, 1}), pi * 10 * 6, 1e-9);
}

TEST(LightCurve, LongestAxisPointsToTheObserverAtPhaseZero) {
  const SpinningBody body = lattice_body({80, 30, 25});
  const LightCurve curve = light_curve(body, pi / 2);
  const auto faintest = std::ranges::min_element(curve.particles) - curve.particles.begin();
  const auto half = static_cast<std::ptrdiff_t>(curve.phase.size() / 2);
  EXPECT_LE(std::min(faintest % half, half - faintest % half), 2);
  EXPECT_NEAR(curve.particles[0], curve.particles[curve.phase.size() / 2], 5);
  EXPECT_EQ(curve.phase[0], 0);
}

TEST(LightCurve, TwoTouchingSpheresVaryLessThanTheirEllipsoidOfInertia) {
  std::vector<Vec3> x = test::moved(askew({40, 40, 40}), Mat3::identity(), {-40, 0, 0});
  const auto other = test::moved(x, Mat3::identity(), {80, 0, 0});
  x.insert(x.end(), other.begin(), other.end());
  const SpinningBody body = spinning_body(x, radius);
  // Two discs beside each other, or one behind the other.
  EXPECT_NEAR(amplitude(light_curve(body, pi / 2).particles), 2.5 * std::log10(2), 0.01);
  // Second moments R^2/5 + R^2 and R^2/5: a/b = sqrt(6).
  EXPECT_NEAR(ellipsoid_amplitude(body.shape, pi / 2), 1.25 * std::log10(6), 0.01);
}

TEST(LightCurve, FlatBodiesAreRefused) {
  std::vector<Vec3> sheet;
  for (int i = 0; i < 100; ++i) sheet.push_back({1.0 * (i % 10), 1.0 * (i / 10), 0});
  EXPECT_THROW(spinning_body(sheet, 1), InputError);
}

TEST(LightCurve, TablesNameTheirUnits) {
  const SpinningBody body = lattice_body({40, 20, 20});
  const std::string curve = light_curve_csv(light_curve(body, pi / 2, 4));
  EXPECT_THAT(curve, testing::StartsWith("rotation_phase_deg,particles_area_m2,particles_mag,"));
  EXPECT_THAT(curve, HasSubstr("\n90,"));
  EXPECT_EQ(std::ranges::count(curve, '\n'), 5);
  const std::string over = amplitudes_csv(amplitudes_over_aspect(body, 3));
  EXPECT_THAT(over, testing::StartsWith("aspect_deg,particles_amplitude_mag,"));
  EXPECT_THAT(over, HasSubstr("\n45,"));
}

TEST(LightCurveFigure, HasBothPanelsInEveryFormat) {
  const test::TemporaryFolder folder;
  const SpinningBody body = lattice_body({40, 20, 20});
  LightCurveFigure figure{light_curve(body, radians(60), 12), amplitudes_over_aspect(body, 4)};
  draw_light_curve(folder / "a.svg", figure);
  const std::string svg = read_file(folder / "a.svg");
  for (const char* words : {"part of one rotation", "aspect of 60°", "ellipsoid of inertia",
                            "amplitude (mag)", "Oumuamua"})
    EXPECT_THAT(svg, HasSubstr(words));
  figure.title = drawing::in_quotes("remnant 2"), figure.period_s = 7.5 * 3600;
  const std::string script = light_curve_script(figure).text();
  for (const char* words : {"\"remnant 2\"", "time (h)", "set xrange [0:7.5]", "\n7.5 "})
    EXPECT_THAT(script, HasSubstr(words));
  draw_light_curve(folder / "a.png", figure);
  EXPECT_THAT(read_file(folder / "a.png"), testing::StartsWith("\x89PNG"));
  draw_light_curve(folder / "a.pdf", figure);
  EXPECT_THAT(read_file(folder / "a.pdf"), testing::StartsWith("%PDF"));
  EXPECT_THROW(draw_light_curve(folder / "a.txt", figure), InputError);
}

}  // namespace
}  // namespace eerie::light_curve
