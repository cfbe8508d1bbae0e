#include <gtest/gtest.h>

#include <algorithm>

#include "solver/initial/bodies.hpp"
#include "solver/step/solver.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::step {
namespace {

/// Positions by id after `cycles` cycles, each followed by a moment of its own where that is not 0.
std::vector<Vec3> after(int cycles, double moment_s) {
  const Scene scene = test::small_scene();
  Solver solver(scene, initial::make_impact(scene));
  for (int k = 0; k < cycles; ++k) {
    solver.cycle(1e9);
    if (moment_s > 0) solver.cycle(solver.state().time + moment_s);
  }
  std::vector<Vec3> x(solver.state().size());
  for (std::size_t i = 0; i < x.size(); ++i) x[solver.state().id[i]] = solver.state().x[i];
  return x;
}

TEST(Gravity, IsNotUpsetByCyclesCutToAMoment) {
  const std::vector<Vec3> calm = after(30, 0);
  for (const double moment : {1e-9, 1e-6, 1e-3}) {
    const std::vector<Vec3> cut = after(30, moment);
    double farthest = 0;
    for (std::size_t i = 0; i < calm.size(); ++i)
      farthest = std::max(farthest, norm(cut[i] - calm[i]));
    // At 0.1 m/s thirty moments are 3 mm at most; a rate of gravity made of rounding is metres.
    EXPECT_LT(farthest, 0.01) << moment;
  }
}

}  // namespace
}  // namespace eerie::step
