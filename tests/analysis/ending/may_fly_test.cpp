#include "analysis/ending/may_fly.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "analysis/flight/flight.hpp"
#include "solver/base/error.hpp"
#include "tests/analysis/remnants/bodies.hpp"
#include "tests/run/runs.hpp"

namespace eerie::ending {
namespace {

using nlohmann::json;
using test::differences;
using test::run_in;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

/// short_impact() that looks every 5 s whether bodies may fly.
Scene flying_impact() {
  return test::short_impact({{"impact", {{"separation", 3}}},
                             {"numerics", {{"rigid_flight", true}, {"late_sound_speed", 0.25}}},
                             {"end", {{"time_s", 420}, {"settled", {{"window_s", 40}}}}}});
}

/// Flies 300 s from the first look after 20 s on, while matter is soft since 10 s.
run::RunOptions flight_at_20s() {
  run::RunOptions options;
  options.look = [](const io::Snapshot& s, const run::LookQuestion& question) -> run::LookAnswer {
    if (question.may_soften && s.state.time > 10 && s.state.time < 20)
      return run::Soften{{0.25, true}};
    if (s.state.time < 20 || s.state.time > 100) return run::GoOn{};
    flight::FlightPlan plan;
    plan.until_s = std::min(question.until, s.state.time + 300);
    plan.spacing = std::cbrt(s.state.mass / 2700);
    plan.heavy = plan.most_landed = std::numeric_limits<double>::infinity();
    return run::Fly{{flight::fly(s.state, plan).state, true, "a test"}};
  };
  return options;
}

TEST(RigidFlight, CarriesARunOverTheTimeInWhichNothingChanges) {
  const TemporaryFolder folder;
  const test::Told told = run_in(folder, flying_impact(), flight_at_20s());
  EXPECT_THAT(told.notes, testing::Contains(HasSubstr("a test")));
  EXPECT_NEAR(told.summary.progress.time, 420, 1e-6);
  // Matter has its own moduli for the impact.
  EXPECT_EQ(told.summary.last.state.softening, particles::Softening{});
  EXPECT_LT(told.summary.progress.step, 150);  // 420 s of matter take four times as many
}

TEST(RigidFlight, HasTheSameBitsForAnyNumberOfThreadsAndOfInterruptions) {
  const Scene scene = flying_impact();
  const TemporaryFolder whole, pieces, threads;
  run::RunOptions options = flight_at_20s();
  run_in(whole, scene, options);
  const io::Snapshot expected = io::read_snapshot(whole / "final.hdf5");
  options.threads = 3;
  run_in(threads, scene, options);
  EXPECT_THAT(differences(io::read_snapshot(threads / "final.hdf5"), expected), IsEmpty());
  options.threads = 1, options.max_steps = 7;
  while (run_in(pieces, scene, options).summary.end == run::RunEnd::step_limit) continue;
  EXPECT_THAT(differences(io::read_snapshot(pieces / "final.hdf5"), expected), IsEmpty());
}

/// Two steady balls of 30 m on a bound orbit, seen for a window.
struct Waiting {
  io::Snapshot now;
  remnants::Remnants found;
  std::vector<RemnantLook> looks;

  explicit Waiting(double apart, double across, double softening = 1) {
    particles::State state = test::empty_state();
    state.time = 1e4, state.softening = {softening, softening < 1};
    test::add_body(state, {30, 30, 30}, {}, {0, -across / 2, 0}, particles::Body::target);
    test::add_body(state, {30, 30, 30}, {apart, 0, 0}, {0, across / 2, 0},
                   particles::Body::impactor);
    now = test::snapshot_of(state);
    now.scene = parse_scene({{"numerics", {{"rigid_flight", true}, {"late_sound_speed", 0.25}}},
                             {"end", {{"time_s", 1e6}, {"settled", {{"window_s", 4000}}}}}});
    found = remnants::find_remnants(state);
    for (int k = looks_per_window; k >= 0; --k)
      for (const RemnantLook& row : look(1e4 - 500.0 * k, found, now.scene.end.settled))
        looks.push_back(row);
  }
  std::optional<particles::Landing> flight() const {
    return flight_from(now, 1e6, looks, found, {});
  }
};

TEST(RigidFlight, EndsWhereTwoRemnantsAreAboutToMeet) {
  const auto landing = Waiting(400, 0.005).flight();
  ASSERT_TRUE(landing.has_value());
  EXPECT_TRUE(landing->for_impact);
  EXPECT_GT(landing->state.time, 1.2e4);
  EXPECT_LT(landing->state.time, 1e5);
  EXPECT_THAT(landing->how, HasSubstr("about to meet"));
}

TEST(RigidFlight, IsNotTakenWithoutSomethingToWaitForOrWithoutRest) {
  EXPECT_FALSE(Waiting(400, 0.2).flight().has_value());  // they part for good
  Waiting restless(400, 0.005);
  for (RemnantLook& row : restless.looks)
    if (row.time_s > 9000) row.b_over_a -= 0.1;
  EXPECT_FALSE(restless.flight().has_value());
}

TEST(RigidFlight, IsNotTakenWhileSoMuchFallsBackThatItWouldEndAtOnce) {
  Waiting waiting(400, 0.005);
  const double total = waiting.now.state.mass * static_cast<double>(waiting.now.state.size());
  const double enough = waiting.now.scene.end.settled.fall_back / 2 * total;
  const remnants::PointMass falling{0.6 * enough, waiting.found.remnants[0].x + Vec3{0, 40, 0},
                                    waiting.found.remnants[0].v};
  waiting.found.debris = {falling};
  EXPECT_TRUE(waiting.flight().has_value());
  waiting.found.debris.push_back(falling);
  EXPECT_FALSE(waiting.flight().has_value());
}

TEST(RigidFlight, GivesMatterItsModuliBackBeforeAnImpact) {
  const Waiting soft(75, 0.005, 0.25), stiff(75, 0.005);
  ASSERT_TRUE(impact_ahead(soft.found, soft.now.scene.end.settled));
  const auto landing = soft.flight();
  ASSERT_TRUE(landing.has_value());
  EXPECT_TRUE(landing->for_impact);
  EXPECT_EQ(landing->state.time, soft.now.state.time);
  EXPECT_FALSE(stiff.flight().has_value());
}

TEST(RigidFlight, IsRefusedWhereNothingLooksOrAnEnergyBudgetIsKept) {
  EXPECT_THAT(
      [] {
        parse_scene({{"numerics", {{"rigid_flight", true}}}});
      },
      ThrowsMessage<InputError>(HasSubstr("end.settled.window_s")));
  EXPECT_THAT(
      [] {
        parse_scene({{"numerics", {{"rigid_flight", true}}},
                     {"material", {{"energy", "integrated"}}},
                     {"end", {{"settled", {{"window_s", 4000}}}}}});
      },
      ThrowsMessage<InputError>(HasSubstr("energy budget")));
}

TEST(RigidFlight, ThatIsOffLeavesTheNameOfAScene) {
  const Scene off = parse_scene({{"numerics", {{"rigid_flight", false}}}});
  EXPECT_FALSE(to_json(off)["numerics"].contains("rigid_flight"));
  EXPECT_EQ(scene_hash(off), scene_hash(parse_scene(json::object())));
}

}  // namespace
}  // namespace eerie::ending
