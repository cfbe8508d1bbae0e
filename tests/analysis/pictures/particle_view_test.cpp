#include "analysis/pictures/particle_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::pictures {
namespace {

constexpr Vec3 ball{50, 50, 50};

/// Bodies of 50 m with their centres `apart` m from each other, each drifting and the first one
/// turning with 1e-4/s about z.
io::Snapshot two_bodies(double apart) {
  particles::State state = test::empty_state();
  const auto x =
      test::moved(test::ellipsoid(ball, test::spacing), Mat3::identity(), {-apart / 2, 0, 0});
  test::add(state, x, test::spinning(x, {0, 0, 1e-4}, {0.1, 0, 0}), particles::Body::target);
  test::add_body(state, ball, {apart / 2, 0, 0}, {-0.1, 0, 0}, particles::Body::impactor);
  return test::snapshot_of(state);
}

TEST(ParticleView, ParticlesFillTheirShareOfTheMaterial) {
  EXPECT_NEAR(sphere_volume(shapes::particle_radius(two_bodies(300))), cubed(test::spacing), 1e-9);
}

TEST(ParticleView, DepthIsCountedFromTheSurfaceOfTheOwnBody) {
  const io::Snapshot first = two_bodies(300);
  const std::vector<double> depth = remnants::initial_depths(first);
  for (std::size_t i = 0; i < first.state.size(); ++i) {
    const double side = first.state.body[i] == 0 ? -150 : 150;
    EXPECT_NEAR(depth[first.state.id[i]], 50 - norm(first.state.x[i] - Vec3{side, 0, 0}), 1e-9);
  }
}

TEST(ParticleView, DepthFollowsAParticleThroughMemory) {
  io::Snapshot first = two_bodies(300);
  const ParticleView before =
      particle_view(first, ParticleColour::depth, remnants::initial_depths(first));
  const std::vector<double> depths = remnants::initial_depths(first);
  first.state = test::shuffled(first.state, 3);
  const ParticleView after = particle_view(first, ParticleColour::depth, depths);
  EXPECT_EQ(before.colour, after.colour);
  EXPECT_THROW(particle_view(first, ParticleColour::depth, std::vector<double>(7)), InputError);
}

TEST(ParticleView, SpeedIsThatWithinTheOwnClump) {
  const io::Snapshot snapshot = two_bodies(300);
  const ParticleView view = particle_view(snapshot, ParticleColour::speed);
  for (std::size_t i = 0; i < view.x.size(); ++i) {
    const Vec3 arm{view.x[i].x + 150, view.x[i].y, 0};
    EXPECT_NEAR(view.colour[i], view.x[i].x < 0 ? 1e-4 * norm(arm) : 0, 1e-9);
  }
}

TEST(ParticleView, NearestParticlesComeLastAndACutLeavesThemOut) {
  const io::Snapshot snapshot = two_bodies(300);
  const ParticleView whole = particle_view(snapshot, ParticleColour::body);
  EXPECT_EQ(whole.x.size(), snapshot.state.size());
  EXPECT_TRUE(std::ranges::is_sorted(whole.x, {}, [](const Vec3& x) { return x.z; }));
  const ParticleView cut = particle_view(snapshot, ParticleColour::body, {}, true);
  EXPECT_EQ(cut.x.size(), snapshot.state.size() / 2);  // no particle lies in the plane itself
  EXPECT_LT(cut.x.back().z, 0);
}

TEST(Frame, HoldsAllRemnantsAboutTheCentreOfMass) {
  const Layout layout = layout_of(two_bodies(300));
  ASSERT_EQ(layout.bodies.size(), 2u);
  EXPECT_NEAR(norm(layout.centre), 0, 1e-9);
  EXPECT_NEAR(layout.body_diameters, 200, 1e-9);
  const Frame frame = frame_of({&layout, 1});
  EXPECT_FALSE(frame.on_largest);
  EXPECT_GT(frame.width, 400);
  EXPECT_LT(frame.width, 440);
  EXPECT_EQ(remnants_outside(frame, layout), 0u);
}

TEST(Frame, FollowsTheLargestRemnantWhereBodiesFlyApart) {
  const std::vector<Layout> panels = {layout_of(two_bodies(300)), layout_of(two_bodies(3000))};
  const Frame frame = frame_of(panels);
  EXPECT_TRUE(frame.on_largest);
  EXPECT_LE(frame.width, widest_frame * 200);
  EXPECT_NEAR(frame_centre(frame, panels[1]).x, -1500, 1e-6);
  EXPECT_EQ(remnants_outside(frame, panels[1]), 1u);
}

/// Whether the panel shows the body from edge to edge.
bool is_whole(const Frame& frame, const Layout& panel, const SeenBody& body) {
  const Vec3 centre = frame_centre(frame, panel);
  const double half = frame.width / 2;
  return body.x_low >= centre.x - half && body.x_high <= centre.x + half &&
         body.y_low >= centre.y - half && body.y_high <= centre.y + half;
}

// The default of impact.separation puts the centres 200 m apart.
TEST(Frame, ShowsBothBodiesWholeAtTheStartThoughTheyFlyApart) {
  const std::vector<Layout> panels = {layout_of(two_bodies(200)), layout_of(two_bodies(3000))};
  const Frame frame = frame_of(panels);
  ASSERT_TRUE(frame.on_largest);
  ASSERT_EQ(panels[0].bodies.size(), 2u);
  for (const SeenBody& body : panels[0].bodies) EXPECT_TRUE(is_whole(frame, panels[0], body));
  EXPECT_TRUE(is_whole(frame, panels[1], panels[1].bodies.front()));
  EXPECT_FALSE(is_whole(frame, panels[1], panels[1].bodies.back()));
}

TEST(Frame, StaysAtTheCentreOfMassWhenOnlySmallRemnantsFlyAway) {
  particles::State state = test::empty_state();
  test::add_body(state, ball, {}, {}, particles::Body::target);
  test::add_body(state, {20, 20, 20}, {2000, 0, 0}, {}, particles::Body::impactor);
  const Layout layout = layout_of(test::snapshot_of(state));
  ASSERT_EQ(layout.bodies.size(), 2u);
  const Frame frame = frame_of({&layout, 1});
  EXPECT_FALSE(frame.on_largest);
  EXPECT_NEAR(frame.width, widest_frame * 200, 1e-9);
  EXPECT_EQ(remnants_outside(frame, layout), 1u);
}

TEST(Frame, IsAsWideAsAskedFor) {
  const Layout layout = layout_of(two_bodies(300));
  EXPECT_EQ(frame_of({&layout, 1}, 1000.0).width, 1000);
  EXPECT_EQ(frame_of({&layout, 1}, 150.0).width, 150);
}

TEST(Frame, DebrisAloneIsShownByItsLargestClump) {
  particles::State state = test::empty_state();
  test::add_body(state, {10, 10, 10}, {}, {}, particles::Body::target);
  const Layout layout = layout_of(test::snapshot_of(state));
  ASSERT_EQ(layout.bodies.size(), 1u);
  EXPECT_GT(frame_of({&layout, 1}).width, 15);
}

TEST(ColourScale, EndsAtARoundNumberThatHoldsAllDepths) {
  const io::Snapshot first = two_bodies(300);
  const ColourScale scale =
      colour_scale(ParticleColour::depth,
                   particle_view(first, ParticleColour::depth, remnants::initial_depths(first)));
  EXPECT_NEAR(scale.top, 50, 1e-9);
  EXPECT_LE(scale.highest, scale.top);
}

TEST(ColourScale, SpeedsOfOneParticleInAHundredMayLieAbove) {
  ParticleView view;
  for (int i = 0; i < 1000; ++i) view.colour.push_back(i < 995 ? 0.9 : 80), view.x.push_back({});
  const ColourScale scale = colour_scale(ParticleColour::speed, view);
  EXPECT_NEAR(scale.top, 1, 1e-12);
  EXPECT_EQ(scale.highest, 80);
}

TEST(PanelImage, ShowsTargetLeftAndImpactorRightInTheirColours) {
  const io::Snapshot snapshot = two_bodies(300);
  const Layout layout = layout_of(snapshot);
  const Frame frame = frame_of({&layout, 1}, 500.0);
  const Bitmap image = panel_image(particle_view(snapshot, ParticleColour::body), frame,
                                   frame_centre(frame, layout), {}, 100);
  EXPECT_EQ(image.width, 100);
  EXPECT_EQ(image.at(20, 50), target_colour);    // -150 m
  EXPECT_EQ(image.at(79, 50), impactor_colour);  // 150 m
  EXPECT_EQ(image.at(50, 50), (drawing::Colour{255, 255, 255}));
}

}  // namespace
}  // namespace eerie::pictures
