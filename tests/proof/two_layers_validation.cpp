#include <gtest/gtest.h>

#include <cmath>

#include "tests/proof/two_layers.hpp"

namespace eerie::proof {
namespace {

TEST(TwoLayers, CarryAWaveThroughTheirBorder) {
  const double ratio = layered_wave_ratio(12);
  RecordProperty("ratio", std::to_string(ratio));
  // A kernel of variance 0.3 h^2 lowers each gradient of a wave by 0.15 (k h)^2, 0.002 here; the
  // border is known to a particle, 1/24 of the bar, across which Z changes.
  EXPECT_NEAR(ratio, 1, 0.01);
}

TEST(TwoLayers, LieOnOneAnotherWithThePressureOfTheirWeight) {
  const LayeredLiquid is = layered_liquid(12);
  RecordProperty("light", std::to_string(is.light));
  RecordProperty("dense", std::to_string(is.dense));
  // The surface is known to a third of a spacing: 1/24 of the depth of the light layer.
  EXPECT_NEAR(is.light, 1, 0.05);
  EXPECT_NEAR(is.dense, 1, 0.01);
  EXPECT_LT(is.voids, 1.0 / 24);  // the particles of the surface at most: none at the border
  EXPECT_LT(is.speed, 1e-3);
}

}  // namespace
}  // namespace eerie::proof
