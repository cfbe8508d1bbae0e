#include <gtest/gtest.h>

#include "tests/proof/cliff.hpp"

namespace eerie::proof {
namespace {

TEST(GranularCliff, FallsAsPublishedAtOneTimeUnitAndAtTheEnd) {
  const auto surfaces = collapse({.aspect = 3.2, .phi_d_deg = 20.9, .across = 8}, {1, 4});
  const double spacing = 1. / 8;
  RecordProperty("start", std::to_string(mean_difference(surfaces[0], published_start())));
  RecordProperty("end", std::to_string(mean_difference(surfaces[1], published_end())));
  // A surface of particles is known to a spacing; at the end most of the pile is 2 to 8 thick.
  EXPECT_LT(mean_difference(surfaces[0], published_start()), spacing);
  EXPECT_LT(mean_difference(surfaces[1], published_end()), spacing);
  // It has come to rest: the fall set a third of M g H0 free, less than a hundredth of it moves.
  EXPECT_LT(surfaces[1].kinetic_energy, 3e-3);
}

}  // namespace
}  // namespace eerie::proof
