#include <gtest/gtest.h>

#include <string>

#include "solver/step/solver.hpp"
#include "tests/proof/lab.hpp"

namespace eerie {
namespace {

TEST(Walls, ALooseGrainThatMeetsItsImageChangesPlacesWithIt) {
  for (const char* kind : {"slip", "rough"}) {
    const Scene scene =
        proof::lab_scene({{"environment", {{"walls", {proof::wall("y_low", 0, kind)}}}},
                          {"numerics", {{"viscosity_alpha", 0}, {"viscosity_beta", 0}}}});
    // Far below the reference density, so that nothing pushes it back before.
    State state = proof::lattice_block({0, 0, 0}, {1, 1, 1}, 1, 2700);
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

}  // namespace
}  // namespace eerie
