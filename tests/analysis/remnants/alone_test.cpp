#include "analysis/remnants/alone.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/mean.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::remnants {
namespace {

/// A ball, and a smaller cigar that lies askew, drifts and turns against its shortest axis.
io::Snapshot ball_and_cigar() {
  const Mat3 askew = test::rotation({1, 2, 3}, 0.7);
  const std::vector<Vec3> cigar =
      test::moved(test::ellipsoid({100, 40, 30}, test::spacing), askew, {900, -300, 50});
  particles::State state = test::empty_state();
  test::add_body(state, {70, 70, 70}, {}, {}, particles::Body::target);
  test::add(state, cigar, test::spinning(cigar, askew * Vec3{0, 0, -1e-3}, {0.2, 0.1, 0}),
            particles::Body::impactor);
  const Vec3 along = askew * Vec3{1, 0, 0};
  // Tension along the cigar.
  for (SymTensor& s : state.S)
    s = {along.x * along.x, along.y * along.y, along.z * along.z,
         along.x * along.y, along.x * along.z, along.y * along.z};
  state.time = 3000, state.step = 17;
  return test::snapshot_of(state);
}

TEST(ARemnantAlone, LiesAlongTheAxesOfSpaceAndTurnsUpward) {
  const Alone cigar = alone(ball_and_cigar(), 2, "final.hdf5");
  const particles::State& s = cigar.snapshot.state;
  EXPECT_EQ(s.size(), test::ellipsoid({100, 40, 30}, test::spacing).size());
  EXPECT_EQ(s.time, 0);
  EXPECT_EQ(s.step, 0);
  EXPECT_EQ(cigar.snapshot.pressure.size(), s.size());
  EXPECT_NEAR(norm(mean(s.x)), 0, 1e-9);
  EXPECT_NEAR(norm(mean(s.v)), 0, 1e-12);
  EXPECT_NEAR(std::abs(cigar.shape.axes[0].x), 1, 1e-9);
  EXPECT_NEAR(std::abs(cigar.shape.axes[2].z), 1, 1e-9);
  EXPECT_NEAR(cigar.shape.b_over_a(), 0.4, 0.01);
  const auto omega = shapes::angular_velocity(s.x, s.v);
  ASSERT_TRUE(omega);
  EXPECT_NEAR(norm(*omega - Vec3{0, 0, 1e-3}), 0, 1e-9);
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    EXPECT_EQ(s.id[i], i);
    EXPECT_NEAR(s.S[i].xx, 1, 1e-9) << "its stress turns with it";
    EXPECT_NEAR(s.S[i].yy, 0, 1e-9);
  }
}

TEST(ARemnantAlone, IsOneThatIsThere) {
  EXPECT_EQ(alone(ball_and_cigar(), 1, "final.hdf5").snapshot.state.size(),
            test::ellipsoid({70, 70, 70}, test::spacing).size());
  try {
    alone(ball_and_cigar(), 3, "final.hdf5");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("final.hdf5 holds 2 remnants"));
  }
}

}  // namespace
}  // namespace eerie::remnants
