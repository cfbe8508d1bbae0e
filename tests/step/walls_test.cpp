#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"

namespace eerie::step {
namespace {

TEST(Walls, ALooseGrainThatMeetsItsImageChangesPlacesWithIt) {
  for (const char* kind : {"slip", "rough"}) {
    const Scene scene =
        proof::lab_scene({{"environment", {{"walls", {proof::wall("y_low", 0, kind)}}}},
                          {"numerics", {{"viscosity_alpha", 0}, {"viscosity_beta", 0}}}});
    // Far below the reference density, so that nothing pushes it back before.
    particles::State state = proof::lattice_block({0, 0, 0}, {1, 1, 1}, 1, 2700);
    state.rho[0] = 500;
    state.v[0] = {0.1, -1, 0};
    Solver solver(scene, state);
    while (solver.state().time < 1) solver.cycle(1);
    const double along = kind == std::string("slip") ? 0.1 : -0.1;
    EXPECT_NEAR(solver.state().x[0].y, 0.5, 1e-9) << kind;  // down and up again
    EXPECT_NEAR(solver.state().v[0].y, 1, 1e-9) << kind;
    EXPECT_NEAR(solver.state().v[0].x, along, 1e-9) << kind;
  }
}

/// Dense layers of grains close to y = 0, at these heights.
particles::State layers(const std::vector<double>& heights) {
  const auto rows = static_cast<double>(heights.size());
  particles::State state = proof::lattice_block({0, 0, 0}, {12, rows, 12}, 1, 2700);
  for (Vec3& x : state.x) x = {0.6 * x.x, heights[static_cast<std::size_t>(x.y)], 0.6 * x.z};
  return state;
}

TEST(Walls, AThinLayerOnAFloorIsNoCollapseThoughItMeetsItsImage) {
  const auto on = [](const nlohmann::json& walls) {
    return proof::lab_scene({{"environment", {{"walls", walls}}}});
  };
  EXPECT_NO_THROW(
      Solver(on(nlohmann::json::array({proof::wall("y_low", 0, "rough")})), layers({0.01})));
  // The same two layers in the open are one.
  try {
    Solver(on(nlohmann::json::array()), layers({-0.01, 0.01}));
    FAIL() << "took a plane for a body";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.kind, "singular-matrix");
  }
}

}  // namespace
}  // namespace eerie::step
