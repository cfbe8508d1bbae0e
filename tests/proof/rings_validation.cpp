#include <gtest/gtest.h>

#include <string>

#include "tests/proof/rings.hpp"

namespace eerie::proof {
namespace {

TEST(RubberRings, BounceAndStayWholeWithArtificialStressOnly) {
  const RingsOutcome whole =
      collide({.spacing = 0.002, .artificial_stress = 0.5, .quarter = true}, 27);
  const RingsOutcome broken =
      collide({.spacing = 0.0015, .artificial_stress = 0, .quarter = true}, 15);
  RecordProperty("rebound", std::to_string(whole.rebound));
  RecordProperty("pieces_without", std::to_string(broken.pieces));
  EXPECT_EQ(whole.pieces, 1);
  EXPECT_EQ(whole.largest_piece, 1);
  // Elastic but for viscosity and oscillations: it leaves with most of its speed.
  EXPECT_GT(whole.rebound, 0.4);
  EXPECT_GT(broken.pieces, 1);
}

}  // namespace
}  // namespace eerie::proof
