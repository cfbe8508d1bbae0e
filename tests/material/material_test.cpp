#include "solver/material/material.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes.hpp"

namespace eerie::material {
namespace {

using test::small_scene;

Scene::Material with_friction(double phi_d_deg, double cohesion_Pa) {
  return small_scene(
             {{"material",
               {{"drucker_prager", {{"phi_d_deg", phi_d_deg}, {"cohesion_Pa", cohesion_Pa}}}}}})
      .material;
}

TEST(DruckerPrager, YieldStressIsCohesionPlusFriction) {
  const DruckerPrager law(with_friction(40, 3));
  EXPECT_DOUBLE_EQ(law.yield_stress(0), 3);
  EXPECT_DOUBLE_EQ(law.yield_stress(10), 3 + 10 * std::tan(radians(40)));
}

TEST(DruckerPrager, StressInsideTheSurfaceIsLeftAloneToTheBit) {
  const DruckerPrager law(with_friction(45, 0));
  const SymTensor S{1, -1, 0, 0.5, 0, 0};  // sqrt(J2) = sqrt(1.25)
  EXPECT_EQ(yielded(law, S, 1.2), S);
  EXPECT_NE(yielded(law, S, 1.1), S);
}

TEST(DruckerPrager, ReturnsRadiallyToTheSurface) {
  const DruckerPrager law(with_friction(45, 0));
  // J2 = 2 * (4^2 + 4^2) / 4 = 16: sqrt(J2) = 4 is cut to mu_d p = 1. tan 45 deg is 1 - 1e-16.
  const SymTensor S = yielded(law, {4, -4, 0, 0, 0, 0}, 1);
  EXPECT_NEAR(S.xx, 1, 1e-15);
  EXPECT_NEAR(S.yy, -1, 1e-15);
}

TEST(DruckerPrager, WithoutPressureAndCohesionNothingIsLeft) {
  const DruckerPrager law(with_friction(40, 0));
  EXPECT_EQ(second_invariant(yielded(law, {4, -4, 0, 1, 2, 3}, 0)), 0);
}

TEST(Tillotson, MatchesThePublishedFormInEachBranch) {
  const Scene::Material m = small_scene(test::stiff_basalt()).material;
  const Tillotson eos(m);
  const Scene::Tillotson& k = m.tillotson;
  const auto cold = [&](double rho, double u) {
    const double eta = rho / 2700, mu = eta - 1;
    return (k.a + k.b / (u / (k.u0_J_per_kg * eta * eta) + 1)) * rho * u + k.A_Pa * mu +
           k.B_Pa * mu * mu;
  };
  const auto hot = [&](double rho, double u) {
    const double eta = rho / 2700, mu = eta - 1, z = 1 / eta - 1;
    return k.a * rho * u + (k.b * rho * u / (u / (k.u0_J_per_kg * eta * eta) + 1) +
                            k.A_Pa * mu * std::exp(-k.beta * z)) *
                               std::exp(-k.alpha * z * z);
  };
  // Formulas of the same numbers in another order: 1e-13.
  EXPECT_NEAR(eos(3000, 1e8).p / cold(3000, 1e8), 1, 1e-13);
  EXPECT_NEAR(eos(2000, 1e6).p / cold(2000, 1e6), 1, 1e-13);
  EXPECT_NEAR(eos(2000, 5e7).p / hot(2000, 5e7), 1, 1e-13);
  const double u = 1e7, w = (u - k.u_iv_J_per_kg) / (k.u_cv_J_per_kg - k.u_iv_J_per_kg);
  EXPECT_NEAR(eos(2000, u).p / ((1 - w) * cold(2000, u) + w * hot(2000, u)), 1, 1e-13);
}

TEST(Tillotson, PressureIsContinuousAcrossVaporisation) {
  const Scene::Material m = small_scene(test::stiff_basalt()).material;
  const Tillotson eos(m);
  for (const double u : {m.tillotson.u_iv_J_per_kg, m.tillotson.u_cv_J_per_kg})
    for (const double rho : {1000.0, 2000.0, 2600.0}) {
      // The same point from both sides, a part in 1e12 apart; slopes are of order p/u.
      EXPECT_NEAR(eos(rho, u * (1 - 1e-12)).p / eos(rho, u * (1 + 1e-12)).p, 1, 1e-10);
    }
}

TEST(Tillotson, SoundSpeedStaysRealWhereTheLawIsNot) {
  const Tillotson eos(small_scene().material);
  for (double rho = 1; rho < 2700; rho *= 1.3) EXPECT_GT(eos(rho, 0).c, 0);
}

TEST(Lundborg, StrengthRunsFromCohesionToTheVonMisesLimit) {
  Scene::Material m = small_scene().material;
  const Lundborg law(m);
  const Scene::Lundborg& k = m.lundborg;
  EXPECT_DOUBLE_EQ(law.yield_stress(0, {0, 0}), k.Y_0_Pa);
  // Half way up where mu_i p = Y_M - Y_0 (Collins, Melosh & Ivanov 2004, eq. 15).
  const double half = (k.Y_M_Pa - k.Y_0_Pa) / k.mu_i;
  EXPECT_DOUBLE_EQ(law.yield_stress(half, {0, 0}), (k.Y_0_Pa + k.Y_M_Pa) / 2);
  EXPECT_NEAR(law.yield_stress(1e15, {0, 0}) / k.Y_M_Pa, 1, 1e-5);  // (Y_M - Y_0)/(mu_i p)
  EXPECT_DOUBLE_EQ(law.yield_stress(-1e9, {0, 0}), k.Y_0_Pa);       // tension counts as zero
}

TEST(Lundborg, HeatSoftensAndMeltHasNoStrength) {
  const Scene::Material m = small_scene().material;
  const Lundborg law(m);
  const double melt = m.lundborg.u_melt_J_per_kg;
  EXPECT_DOUBLE_EQ(law.yield_stress(1e6, {melt / 4, 0}), 0.75 * law.yield_stress(1e6, {0, 0}));
  EXPECT_EQ(law.yield_stress(1e9, {melt, 0}), 0);
  EXPECT_EQ(law.yield_stress(1e9, {2 * melt, 0.5}), 0);
}

TEST(Lundborg, RubbleHasFrictionUpToTheStrengthOfRock) {
  const Scene::Material m = with_friction(40, 2);
  const Lundborg law(m);
  EXPECT_DOUBLE_EQ(law.yield_stress(100, {0, 1}), 2 + 100 * std::tan(radians(40)));
  EXPECT_DOUBLE_EQ(law.yield_stress(1e12, {0, 1}), law.yield_stress(1e12, {0, 0}));
  EXPECT_DOUBLE_EQ(law.yield_stress(100, {0, 0.5}),
                   (law.yield_stress(100, {0, 0}) + law.yield_stress(100, {0, 1})) / 2);
}

TEST(Material, LongitudinalWaveIsFasterThanSoundByShear) {
  const Material sheared = make_material(small_scene().material);
  const Material fluid =
      make_material(small_scene({{"material", {{"rheology", "fluid"}}}}).material);
  EXPECT_DOUBLE_EQ(sheared.longitudinal_speed(), std::sqrt((26700 + 4 * 22700 / 3.0) / 2700));
  EXPECT_DOUBLE_EQ(fluid.longitudinal_speed(), std::sqrt(26700 / 2700.0));
}

TEST(Material, YoungModulusFollowsFromBulkAndShear) {
  // K = 26,700 and G = 22,700 Pa: E = 9 K G/(3 K + G), and back again nu = E/(2G) - 1.
  const double E = make_material(small_scene().material).young_modulus();
  const double nu = E / (2 * 22700) - 1;
  EXPECT_NEAR(E / (3 * (1 - 2 * nu)), 26700, 1e-8);
}

TEST(Material, UnknownNamesAreRefused) {
  Scene scene = small_scene();
  scene.material.rheology = "jelly";
  EXPECT_THROW(make_material(scene.material), InputError);
}

}  // namespace
}  // namespace eerie::material
