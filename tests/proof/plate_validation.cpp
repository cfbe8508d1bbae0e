#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/proof/lab.hpp"
#include "tests/proof/plate.hpp"

namespace eerie::proof {
namespace {

TEST(ElasticPlate, SwingsWithThePeriodOfTheoryAndConvergesToIt) {
  const double theory =
      thin_plate_period(Support::free) * (1 + thickness_correction(Support::free));
  const auto error = [&](int layers) {
    const Oscillation o = plate_oscillation(Support::free, layers, 0);
    EXPECT_LT(o.z_drift, 1e-3);
    RecordProperty("layers_" + std::to_string(layers), std::to_string(o.period / theory));
    return o.period / theory - 1;
  };
  const double coarse = error(4), fine = error(6);
  // Smoothing takes a share of order (h/H)^2 of the stiffness, with h = 1.2 H/layers.
  EXPECT_LT(std::abs(fine), 3 * (1.2 / 6) * (1.2 / 6));
  EXPECT_LT(std::abs(fine), 0.6 * std::abs(coarse));
  // So the error goes to nothing with its square. Where the pressure's gradient is not corrected
  // its error at the faces, of the other sign, goes otherwise.
  const bool clean = lab_scene(nlohmann::json::object()).numerics.gradient == "corrected-fully";
  EXPECT_NEAR((36 * fine - 16 * coarse) / 20, 0, clean ? 0.01 : 0.04);
}

TEST(ElasticPlate, StaysElasticUnderArtificialStress) {
  const double with = plate_oscillation(Support::free, 4).period,
               without = plate_oscillation(Support::free, 4, 0).period;
  // It takes at most the share 0.3 of the tension, which is half of the bending stress.
  EXPECT_GT(with / without, 1);
  EXPECT_LT(with / without, 1 + 0.3 / 4);
}

}  // namespace
}  // namespace eerie::proof
