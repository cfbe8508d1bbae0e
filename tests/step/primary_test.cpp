#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::step {
namespace {

/// Two layers of grains that are one plane, about `middle`.
particles::State collapsed(const Vec3& middle) {
  particles::State state = proof::lattice_block({0, 0, 0}, {12, 2, 12}, 1, 2700);
  for (Vec3& x : state.x)
    x = middle + Vec3{0.6 * (x.x - 6), x.y < 1 ? -0.01 : 0.01, 0.6 * (x.z - 6)};
  return state;
}

TEST(Primary, TakesInWhatPilesUpAboutItsCentre) {
  const Scene scene = test::small_scene(
      {{"environment",
        {{"primary", {{"mass_kg", 4.95e11}, {"radius_m", 360}, {"distance_m", 1500}}}}}});
  EXPECT_NO_THROW(Solver(scene, collapsed({1500, 0, 0})));
  try {
    Solver(scene, collapsed({0, 0, 0}));
    FAIL() << "took a plane for a body";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.kind, "singular-matrix");
  }
}

}  // namespace
}  // namespace eerie::step
