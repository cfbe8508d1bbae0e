#include "analysis/disk/encounter_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"

namespace eerie::disk {
namespace {

struct Here {
  Nebula nebula = hayashi_nebula(7 * astronomical_unit);
  Drag drag = weidenschilling_drag(nebula, {});
};

TEST(TurbulentSpeed, IsSonicWhereThreeAlphaIsTheStoppingTime) {
  const Here here;
  const double alpha = here.nebula.omega_k * here.drag.stopping_time / 3;
  EXPECT_NEAR(turbulent_speed(here.nebula, here.drag, alpha), here.nebula.sound_speed, 1e-9);
}

TEST(TurbulentSpeed, GrowsAsTheRootOfAlphaAndFallsAsThatOfTheStoppingTime) {
  const Here here;
  Drag longer = here.drag;
  longer.stopping_time *= 4;
  const double v = turbulent_speed(here.nebula, here.drag, 1e-4);
  EXPECT_NEAR(turbulent_speed(here.nebula, here.drag, 9e-4), 3 * v, 1e-12);
  EXPECT_NEAR(turbulent_speed(here.nebula, longer, 1e-4), v / 2, 1e-12);
}

TEST(TurbulentSpeed, IsUndoneByAlphaAtSpeed) {
  const Here here;
  for (const double speed : {0.01, 0.15, 0.4, 30.0})
    EXPECT_NEAR(
        turbulent_speed(here.nebula, here.drag, alpha_at_speed(here.nebula, here.drag, speed)),
        speed, 1e-12 * speed);
}

TEST(EscapeVelocity, CarriesABodyJustToInfinity) {
  constexpr double radius = 2000, rho = 2700;
  const double v = escape_speed({radius, rho});
  EXPECT_NEAR(v * v / 2, newton_G * sphere_volume(radius) * rho / radius, 1e-12);
}

TEST(StirredSpeed, BalancesStirringAndDrag) {
  const Here here;
  const Stirrers stirrers{0.03, 1500};
  for (const double radius : {300.0, 5e3, 2e5}) {
    const double u = stirred_speed(here.nebula, here.drag, stirrers, radius);
    // Eqs. (8) and (9): the rates of growth and of damping.
    const double sigma = 0.03 * here.nebula.solid_surface_density;
    const double growth = here.nebula.omega_k * sigma / (1500 * radius) *
                          std::pow(escape_speed({radius, 1500}) / u, 4);
    EXPECT_NEAR(growth * here.drag.stopping_time, 1, 1e-12) << radius;
  }
}

TEST(StirredSpeed, GrowsAsTheRadiusToThreeFourthsAndTheRootOfTheRootOfTheMass) {
  const Here here;
  const double u = stirred_speed(here.nebula, here.drag, {}, 1000);
  EXPECT_NEAR(stirred_speed(here.nebula, here.drag, {}, 16000), 8 * u, 1e-12);
  EXPECT_NEAR(stirred_speed(here.nebula, here.drag, {0.16, 2700}, 1000), 2 * u, 1e-12);
}

TEST(StirredSpeed, IsUndoneByStirrerRadiusAtSpeed) {
  const Here here;
  for (const double speed : {0.01, 0.15, 0.4, 30.0})
    EXPECT_NEAR(stirred_speed(here.nebula, here.drag, {},
                              stirrer_radius_at_speed(here.nebula, here.drag, {}, speed)),
                speed, 1e-12 * speed);
}

}  // namespace
}  // namespace eerie::disk
