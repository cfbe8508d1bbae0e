#include "analysis/disk/nebula.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie::disk {
namespace {

constexpr double au = astronomical_unit;

TEST(HayashiNebula, HasTheRoundedNumbersThatHePrints) {
  const Nebula n = hayashi_nebula(au);
  EXPECT_EQ(n.gas_surface_density, 1.7e4);
  EXPECT_NEAR(n.gas_density, 1.4e-6, 0.05e-6);  // 1.4e-9 g/cm^3
  // His scale height is that of exp(-z^2/h^2): 0.047 AU.
  EXPECT_NEAR(std::sqrt(2.0) * n.scale_height() / au, 0.047, 0.0005);
  EXPECT_NEAR(hayashi_nebula(2.7 * au).temperature, 170, 0.5);  // ice condenses
}

TEST(HayashiNebula, TurnsOnceAYearAtTheEarth) {
  constexpr double day = 86400;
  EXPECT_NEAR(2 * pi / hayashi_nebula(au).omega_k / day, 365.25, 0.02);
  EXPECT_NEAR(hayashi_nebula(au).keplerian_speed(), 29780, 10);
}

TEST(HayashiNebula, GetsItsIceAtTheSnowLine) {
  const double inside = hayashi_nebula(2.6999 * au).solid_surface_density;
  const double outside = hayashi_nebula(2.7 * au).solid_surface_density;
  EXPECT_NEAR(outside / inside, 300.0 / 71, 1e-3);
  EXPECT_NEAR(hayashi_nebula(4 * au).solid_surface_density, 300.0 / 8, 1e-9);
}

TEST(HayashiNebula, MidplaneDensityAddsUpToTheSurfaceDensity) {
  for (const double r : {0.5, 5.0, 50.0}) {
    const Nebula n = hayashi_nebula(r * au);
    const double h = n.scale_height(), dz = h / 50;
    double sum = 0;  // the rectangle rule is exact to rounding for a Gaussian
    for (int i = -500; i <= 500; ++i) {
      const double z = i * dz;
      sum += n.gas_density * std::exp(-z * z / (2 * h * h)) * dz;
    }
    EXPECT_NEAR(sum, n.gas_surface_density, 1e-9 * sum) << r;
  }
}

TEST(HayashiNebula, HeadWindBalancesThePressureGradient) {
  const auto pressure = [](double r) {
    const Nebula n = hayashi_nebula(r);
    return n.gas_density * n.sound_speed * n.sound_speed;
  };
  for (const double r : {0.5 * au, 5 * au, 50 * au}) {
    const double dr = 1e-4 * r;
    const double gradient = (pressure(r + dr) - pressure(r - dr)) / (2 * dr);
    const Nebula n = hayashi_nebula(r);
    // Radial balance of the gas to first order: 2 Omega (v_K - v_gas) = -(dP/dr) / rho.
    EXPECT_NEAR(n.head_wind, -gradient / (2 * n.omega_k * n.gas_density), 1e-6 * n.head_wind);
  }
  EXPECT_NEAR(hayashi_nebula(50 * au).head_wind, hayashi_nebula(au).head_wind, 1e-9);
}

}  // namespace
}  // namespace eerie::disk
