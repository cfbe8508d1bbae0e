#include <gtest/gtest.h>

#include <cmath>

#include "solver/material/material.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/variant_types.hpp"

namespace eerie::material {
namespace {

using test::small_scene;
using test::stiff_basalt;

/// What every equation of state owes to the solver, with the reduced moduli of the default scene
/// and with those of real basalt.
template <class Eos>
class EosContract : public testing::Test {
 protected:
  const std::vector<Scene::Material> materials{small_scene().material,
                                               small_scene(stiff_basalt()).material};
};
TYPED_TEST_SUITE(EosContract, test::AlternativesOf<Eos>, test::NameByToken);

/// Energies that cover every branch: cold, incipient, partial and complete vaporisation.
constexpr double energies[] = {0, 1, 1e3, 1e6, 4.6e6, 4.8e6, 1e7, 1.8e7, 1.9e7, 1e8, 5e8};

/// The largest |f(x + dx) - f(x)| left when the interval with the largest change is halved again
/// and again: what remains of a continuous function is rounding, of a jump the jump.
template <class F>
double remaining_jump(F f, double lo, double hi) {
  constexpr int pieces = 400;
  for (int depth = 0; depth < 12; ++depth) {
    const double dx = (hi - lo) / pieces;
    double largest = -1, at = lo;
    for (int k = 0; k < pieces; ++k) {
      const double x = lo + k * dx, change = std::abs(f(x + dx) - f(x));
      if (change > largest) largest = change, at = x;
    }
    lo = at, hi = at + dx;
    if (hi - lo < 1e-13 * std::abs(hi)) break;
  }
  return std::abs(f(hi) - f(lo));
}

TEST(RemainingJump, SeesAStepAndNoSlope) {
  EXPECT_NEAR(remaining_jump([](double x) { return x < 0.3 ? 0 : 1e-3; }, 0.0, 1.0), 1e-3, 1e-9);
  EXPECT_LT(remaining_jump([](double x) { return 1e3 * x * x; }, 0.0, 1.0), 1e-9);
}

TYPED_TEST(EosContract, UncompressedColdMaterialHasNoPressure) {
  for (const auto& m : this->materials) {
    const TypeParam eos(m);
    EXPECT_EQ(eos(m.rho0_kg_per_m3, 0).p, 0);
    EXPECT_EQ(eos.reference_density(), m.rho0_kg_per_m3);
  }
}

TYPED_TEST(EosContract, ReferenceSoundSpeedIsThatOfUncompressedColdMaterial) {
  if (!TypeParam::is_cold) {
    EXPECT_EQ(TypeParam(this->materials[0]).reference_sound_speed(), 0);
    return;
  }
  for (const auto& m : this->materials) {
    const TypeParam eos(m);
    // The same formula in another order: rounding only.
    EXPECT_NEAR(eos(m.rho0_kg_per_m3, 0).c / eos.reference_sound_speed(), 1, 1e-14);
  }
}

TYPED_TEST(EosContract, TheSceneKnowsItsSoundSpeedToo) {
  // Estimates and warnings go by the scene alone; a new law must be known there as well.
  for (const auto& material : this->materials) {
    Scene scene = small_scene();
    scene.material = material;
    scene.material.eos = TypeParam::token;
    EXPECT_DOUBLE_EQ(bulk_sound_speed(scene), TypeParam(material).reference_sound_speed());
  }
}

TYPED_TEST(EosContract, ColdCompressionRaisesPressureAndSoundSpeed) {
  for (const auto& m : this->materials) {
    const TypeParam eos(m);
    for (double eta = 1; eta < 1.5; eta += 0.01) {
      const double rho = eta * m.rho0_kg_per_m3;
      // What has no cold pressure has it when warm.
      const double u = TypeParam::is_cold ? 0 : 1e3;
      EXPECT_GT(eos(rho * 1.01, u).p, eos(rho, u).p);
      EXPECT_GE(eos(rho * 1.01, 0).c, eos(rho, 0).c * (1 - 1e-12));
    }
  }
}

TYPED_TEST(EosContract, PressureIsContinuousInDensity) {
  for (const auto& m : this->materials) {
    const TypeParam eos(m);
    for (const double u : energies) {
      const auto p = [&](double rho) { return eos(rho, u).p; };
      const double lo = 0.2 * m.rho0_kg_per_m3, hi = 1.6 * m.rho0_kg_per_m3;
      // The interval ends at 1e-13 of rho: what is left is slope times that, and rounding.
      const double scale = std::abs(p(hi)) + std::abs(p(lo));
      EXPECT_LE(remaining_jump(p, lo, hi), 1e-11 * scale) << "u = " << u;
    }
  }
}

TYPED_TEST(EosContract, PressureIsContinuousInEnergy) {
  for (const auto& m : this->materials) {
    const TypeParam eos(m);
    for (const double eta : {0.2, 0.5, 0.8, 0.95, 0.999, 1.0, 1.001, 1.1, 1.5}) {
      const double rho = eta * m.rho0_kg_per_m3;
      const auto p = [&](double u) { return eos(rho, u).p; };
      // As above; the vaporisation energies lie inside the range.
      EXPECT_LE(remaining_jump(p, 0.0, 4e7), 1e-11 * (std::abs(p(4e7)) + std::abs(p(0))))
          << "rho/rho0 = " << eta;
    }
  }
}

TYPED_TEST(EosContract, SoundSpeedIsTheAdiabaticDerivativeOfPressure) {
  int compared = 0;
  for (const auto& m : this->materials) {
    const TypeParam eos(m);
    const double rho0 = m.rho0_kg_per_m3;
    for (const double u : energies)
      for (const double eta : {0.3, 0.5, 0.7, 0.9, 0.97, 0.995, 1.005, 1.02, 1.1, 1.3, 1.6}) {
        const double rho = eta * rho0, drho = 1e-5 * rho, du = 1e-5 * std::max(u, 1e3);
        const double dp_drho = (eos(rho + drho, u).p - eos(rho - drho, u).p) / (2 * drho);
        // Energies are not negative: one-sided at u = 0, of second order like the other.
        const double dp_du =
            u >= du
                ? (eos(rho, u + du).p - eos(rho, u - du).p) / (2 * du)
                : (4 * eos(rho, u + du).p - eos(rho, u + 2 * du).p - 3 * eos(rho, u).p) / (2 * du);
        const EosPoint point = eos(rho, u);
        const double c2 = dp_drho + point.p / (rho * rho) * dp_du;
        const double reference = eos.reference_sound_speed() * eos.reference_sound_speed();
        // Steps of 1e-5: truncation about 1e-10, rounding of p about 1e-11 relative to p/dp.
        const double c2_given = point.c * point.c, tolerance = 1e-5 * std::max(c2, reference);
        EXPECT_GE(c2_given, c2 - tolerance) << "rho " << rho << " u " << u;
        // A law may keep c above a floor where it is not hyperbolic, up to the reference speed.
        if (c2 < reference && c2_given > c2 + tolerance) {
          EXPECT_LE(c2_given, reference * (1 + 1e-12)) << "rho " << rho << " u " << u;
          continue;
        }
        EXPECT_LE(c2_given, c2 + tolerance) << "rho " << rho << " u " << u;
        ++compared;
      }
  }
  EXPECT_GT(compared, 100);
}

TYPED_TEST(EosContract, DensityAtInvertsColdPressure) {
  for (const auto& m : this->materials) {
    const TypeParam eos(m);
    const double stiffness =
        m.rho0_kg_per_m3 * eos.reference_sound_speed() * eos.reference_sound_speed();
    for (double p = 1e-6 * stiffness; TypeParam::is_cold && p < stiffness; p *= 3)
      // rho - rho0 keeps 1e-16/1e-6 of its digits at the lowest pressure.
      EXPECT_NEAR(eos(eos.density_at(p), 0).p / p, 1, 1e-9);
    EXPECT_EQ(eos.density_at(0), m.rho0_kg_per_m3);
  }
}

}  // namespace
}  // namespace eerie::material
