#include "campaign/auto_fidelity/auto_fidelity.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/job.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::auto_fidelity {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::ThrowsMessage;

const json grid = {{"name", "ridge"},
                   {"grid", {{"v_imp_cm_per_s", {15, 18, 20, 22}}, {"theta_imp_deg", {10, 15}}}}};

/// A ladder of two rungs, but where a test wants more.
AutoFidelity new_campaign(AutoOptions options = {}, const json& sweep = grid,
                          const char* finest = "survey") {
  return AutoFidelity(ladder(sweep, {}, "ridge.json", finest), options);
}
constexpr std::size_t sketch = 0, survey = 1;

TEST(Ladder, BeginsWhereEveryImpactorHasParticlesEnough) {
  json sweep = grid;
  sweep["grid"]["q"] = {1, 0.1};  // sketches would give it 40, surveys 100
  const std::vector<Rung> rungs = ladder(sweep, {}, "ridge.json", "standard");
  ASSERT_EQ(rungs.size(), 2u);
  EXPECT_EQ(rungs.front().name, "survey");
  EXPECT_THAT([&] { ladder(sweep, {}, "ridge.json", "sketch"); },
              ThrowsMessage<InputError>(HasSubstr("would have 40 particles")));
}

/// What a solver would say: b/a falls with speed; at 20 cm/s it is close to 0.3, and at 22 cm/s
/// every other seed splits.
db::Result outcome_of(const Scene& s) {
  const auto seed = static_cast<double>(s.numerics.seed);
  const double noise = 0.01 * std::sin(2.4 * seed);
  const double v = s.impact.v_imp_cm_per_s;
  db::Result r = test::sample_result(v == 20 ? 0.3 + noise : 0.6 - 0.001 * v + noise);
  if (v == 22 && s.numerics.seed % 2 == 0) r.outcome_class = "hit-and-run";
  return r;
}

/// Runs what is wanted until nothing is; how many runs that took. `fails`: never gives a result.
template <class Fails>
std::size_t run_out(AutoFidelity& campaign, db::Connection& connection, Fails&& fails) {
  std::set<std::string> ran;
  for (int round = 0; round < 50; ++round) {
    campaign.update(connection);
    std::size_t fresh = 0;
    for (const auto& [scene, rung] : campaign.next()) {
      EXPECT_EQ(sweeps::fidelity_of(to_json(scene)), campaign.rungs()[rung].name);
      if (!ran.insert(scene_hash(scene)).second) continue;
      ++fresh;
      const db::NewJob job = sweeps::new_job(scene);
      const db::AddedSweep added = db::add_sweep(connection, job.hash, "{}", std::vector{job});
      if (fails(scene)) continue;
      const std::int64_t id = db::jobs(connection, {added.sweep}).front().id;
      db::AttemptEnd end = test::ended(db::ExitReason::finished);
      end.core_seconds = scene.numerics.particles_per_target == 1000 ? 15 : 4;
      db::begin_attempts(connection, std::vector{db::Start{id, "here", "", "1"}});
      db::finish(connection, id, end, outcome_of(scene), {});
    }
    if (fresh == 0) break;
  }
  campaign.update(connection);
  return ran.size();
}

const AutoCell& cell_at(const AutoFidelity& campaign, double v) {
  return *std::ranges::find(campaign.cells(), v, [](const AutoCell& c) {
    return c.scenes.front().impact.v_imp_cm_per_s;
  });
}

TEST(AutoFidelity, SketchesEveryImpactFirst) {
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity campaign = new_campaign();
  campaign.update(connection);
  const std::vector<Wanted> first = campaign.next();
  ASSERT_EQ(first.size(), 16u);
  for (const Wanted& run : first) EXPECT_EQ(sweeps::fidelity_of(to_json(run.scene)), "sketch");
  EXPECT_TRUE(campaign.in_doubt(campaign.cells().front()));
}

TEST(AutoFidelity, GoesOnlyWhereItIsInDoubt) {
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity campaign = new_campaign();
  run_out(campaign, connection, [](const Scene&) { return false; });
  for (const double clear : {15.0, 18.0}) {
    const AutoCell& cell = cell_at(campaign, clear);
    EXPECT_EQ(campaign.fidelity(cell), "sketch") << clear;
    EXPECT_EQ(cell.runs[sketch].size(), 2u);
    EXPECT_TRUE(cell.runs[survey].empty());
    EXPECT_FALSE(campaign.in_doubt(cell));
  }
  for (const double doubtful : {20.0, 22.0}) {
    const AutoCell& cell = cell_at(campaign, doubtful);
    EXPECT_EQ(campaign.fidelity(cell), "survey") << doubtful;
    EXPECT_TRUE(campaign.in_doubt(cell));
  }
  // Four more could make neither nine in ten: both answers are that it may be either.
  for (const double mixed : {20.0, 22.0}) {
    EXPECT_EQ(cell_at(campaign, mixed).runs[survey].size(), 4u);
    EXPECT_TRUE(campaign.is_mixed(cell_at(campaign, mixed)));
  }
  EXPECT_NEAR(cell_at(campaign, 20).verdict.p_elongated, 0.5, 0.2);
  EXPECT_LT(cell_at(campaign, 22).verdict.p_outcome, 0.7);
  const std::vector<double> spent = campaign.core_seconds();
  EXPECT_EQ(spent[survey], 2 * (4 + 4) * 15);
  EXPECT_LT(spent[sketch] + spent[survey], 0.4 * 8 * 8 * 15);
  EXPECT_EQ(campaign.uniform_core_seconds(), 8 * 8 * 15);
  EXPECT_THAT(auto_csv(campaign), HasSubstr("1,40,15,10,sketch,2,2,0,perfect-merging,0.900,"));
}

TEST(AutoFidelity, NeedsMoreRunsWhereNoNeighbourIsOfTheSameClass) {
  const json one = {{"name", "one"}, {"grid", {{"v_imp_cm_per_s", {15}}, {"theta_imp_deg", {10}}}}};
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity alone = new_campaign({}, one);
  run_out(alone, connection, [](const Scene&) { return false; });
  EXPECT_EQ(cell_at(alone, 15).runs[sketch].size(), 4u);
  EXPECT_FALSE(alone.in_doubt(cell_at(alone, 15)));
}

TEST(AutoFidelity, TakesForNeighboursWhatIsOneStepOfSpeedOrAngleAway) {
  const AutoFidelity campaign = new_campaign();  // 2 angles by 4 speeds; speeds vary fastest
  EXPECT_THAT(campaign.cells()[0].neighbours, testing::UnorderedElementsAre(1, 4));
  EXPECT_THAT(campaign.cells()[5].neighbours, testing::UnorderedElementsAre(1, 4, 6));
  const json other = {{"name", "q"}, {"grid", {{"q", {0.5, 1}}, {"v_imp_cm_per_s", {15, 18}}}}};
  const AutoFidelity two = new_campaign({}, other);
  EXPECT_THAT(two.cells()[0].neighbours, testing::ElementsAre(1));
}

TEST(AutoFidelity, AsksForNothingThatItIsSureOf) {
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity strict = new_campaign({0.95, 16}), easy = new_campaign({0.75, 16});
  const std::size_t most = run_out(strict, connection, [](const Scene&) { return false; });
  const test::TemporaryFolder other;
  db::Connection second(other / "b.sqlite", db::Access::write);
  const std::size_t fewest = run_out(easy, second, [](const Scene&) { return false; });
  EXPECT_LT(3 * fewest, 2 * most);
}

TEST(AutoFidelity, TakesResultsThatAreThereAndGoesOnFromThem) {
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity first = new_campaign();
  run_out(first, connection, [](const Scene&) { return false; });
  AutoFidelity again = new_campaign();
  again.update(connection);
  EXPECT_TRUE(again.next().empty());
  EXPECT_EQ(auto_csv(again), auto_csv(first));
}

TEST(AutoFidelity, IsNoLessSureForASurveyThatSaysTheSame) {
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity campaign = new_campaign();
  run_out(campaign, connection, [](const Scene&) { return false; });
  const AutoCell clear = cell_at(campaign, 15);
  ASSERT_EQ(campaign.fidelity(clear), "sketch");
  const db::NewJob job = sweeps::new_job(clear.scenes[survey]);
  const std::int64_t sweep = db::add_sweep(connection, "more", "{}", std::vector{job}).sweep;
  const std::int64_t id = db::jobs(connection, {sweep}).front().id;
  db::begin_attempts(connection, std::vector{db::Start{id, "here", "", "1"}});
  db::finish(connection, id, test::ended(db::ExitReason::finished),
             outcome_of(clear.scenes[survey]), {});
  campaign.update(connection);
  EXPECT_EQ(cell_at(campaign, 15).runs[survey].size(), 1u);
  EXPECT_EQ(campaign.fidelity(cell_at(campaign, 15)), "sketch");
  EXPECT_TRUE(campaign.next().empty());
}

TEST(AutoFidelity, ClimbsRungByRungWhereDoubtIsLeft) {
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity campaign = new_campaign({}, grid, "standard");
  run_out(campaign, connection, [](const Scene&) { return false; });
  const AutoCell &clear = cell_at(campaign, 15), &doubtful = cell_at(campaign, 20);
  EXPECT_EQ(clear.finest(), 0);
  // No seeds are spent where they could not help: two below, four on the last rung.
  EXPECT_EQ(campaign.fidelity(doubtful), "standard");
  EXPECT_EQ(doubtful.runs[sketch].size(), 2u);
  EXPECT_EQ(doubtful.runs[survey].size(), 2u);
  EXPECT_EQ(doubtful.runs[2].size(), 4u);
}

TEST(AutoFidelity, LearnsFromEachRungWhatTheOneBelowErrs) {
  // Every sketch lies 0.1 above what finer runs say.
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  const auto add = [&](Scene scene, double b_over_a) {
    for (const int seed : {1, 2}) {
      scene.numerics.seed = seed;
      const db::NewJob job = sweeps::new_job(scene);
      const std::int64_t sweep = db::add_sweep(connection, job.hash, "{}", std::vector{job}).sweep;
      const std::int64_t id = db::jobs(connection, {sweep}).front().id;
      db::begin_attempts(connection, std::vector{db::Start{id, "here", "", "1"}});
      db::finish(connection, id, test::ended(db::ExitReason::finished),
                 test::sample_result(b_over_a), {});
    }
  };
  AutoFidelity campaign = new_campaign({}, grid, "standard");
  for (const AutoCell& cell : campaign.cells()) {
    add(cell.scenes[sketch], 0.5), add(cell.scenes[survey], 0.4);
  }
  campaign.update(connection);
  const std::string merger = test::sample_result(0.5).outcome_class;
  // Eight impacts against prior knowledge worth four.
  EXPECT_NEAR(campaign.transfer(sketch, merger).shift, -0.1 * 8 / 12, 1e-12);
  EXPECT_EQ(campaign.transfer(survey, merger).shift, 0);
  EXPECT_EQ(campaign.transfer(survey, merger).scatter, 0.05);
}

TEST(AutoFidelity, RefusesALastRungThatIsNone) {
  EXPECT_THAT([] { new_campaign({}, grid, "paper"); },
              ThrowsMessage<InputError>(
                  HasSubstr("--finest paper: must be one of sketch, survey, standard, fine")));
}

TEST(AutoFidelity, EndsWhereRunsFail) {
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity campaign = new_campaign();
  run_out(campaign, connection, [](const Scene& s) {
    return s.impact.v_imp_cm_per_s == 15 && s.impact.theta_imp_deg == 10;
  });
  EXPECT_FALSE(campaign.cells().front().is_known());
  EXPECT_TRUE(campaign.in_doubt(campaign.cells().front()));
  EXPECT_FALSE(campaign.in_doubt(cell_at(campaign, 18)));
}

TEST(AutoFidelity, RefusesAConfidenceThatItsSeedsCannotGive) {
  EXPECT_THAT(
      [] {
        new_campaign({0.95, 8});
      },
      ThrowsMessage<InputError>(HasSubstr("--most-seeds 9 or more")));
  EXPECT_NO_THROW(new_campaign({0.95, 9}));
}

TEST(AutoFidelity, RefusesAGridOfSeeds) {
  const json seeds = {{"name", "s"}, {"grid", {{"numerics.seed", {1, 2}}}}};
  EXPECT_THAT([&] { new_campaign({}, seeds); },
              ThrowsMessage<InputError>(HasSubstr("numerics.seed")));
}

}  // namespace
}  // namespace eerie::auto_fidelity
