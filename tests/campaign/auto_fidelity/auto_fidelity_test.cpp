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

sweeps::Sweep sweep_at(const char* fidelity, const json& sweep = grid) {
  return sweeps::parse_sweep(sweep, sweeps::overrides_of_fidelity(fidelity), "ridge.json");
}

AutoFidelity new_campaign(AutoOptions options = {}) {
  return AutoFidelity(sweep_at("sketch"), sweep_at("survey"), options);
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
    for (const auto& [scene, survey] : campaign.next()) {
      EXPECT_EQ(survey, scene.numerics.particles_per_target == 1000);
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
  return *std::ranges::find(campaign.cells(), v,
                            [](const AutoCell& c) { return c.survey_scene.impact.v_imp_cm_per_s; });
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
    EXPECT_EQ(cell.fidelity, "sketch") << clear;
    EXPECT_EQ(cell.sketch.size(), 2u);
    EXPECT_TRUE(cell.survey.empty());
    EXPECT_FALSE(campaign.in_doubt(cell));
  }
  for (const double doubtful : {20.0, 22.0}) {
    const AutoCell& cell = cell_at(campaign, doubtful);
    EXPECT_EQ(cell.fidelity, "survey") << doubtful;
    EXPECT_TRUE(campaign.in_doubt(cell));
  }
  // Four more could make neither nine in ten: both answers are that it may be either.
  for (const double mixed : {20.0, 22.0}) {
    EXPECT_EQ(cell_at(campaign, mixed).survey.size(), 4u);
    EXPECT_TRUE(campaign.is_mixed(cell_at(campaign, mixed)));
  }
  EXPECT_NEAR(cell_at(campaign, 20).verdict.p_elongated, 0.5, 0.2);
  EXPECT_LT(cell_at(campaign, 22).verdict.p_outcome, 0.7);
  const auto spent = campaign.core_seconds();
  EXPECT_EQ(spent.at("survey"), 2 * (4 + 4) * 15);
  EXPECT_LT(spent.at("sketch") + spent.at("survey"), 0.4 * 8 * 8 * 15);
  EXPECT_EQ(campaign.uniform_core_seconds(), 8 * 8 * 15);
  EXPECT_THAT(auto_csv(campaign), HasSubstr("1,40,15,10,sketch,2,2,perfect-merging,0.900,"));
}

TEST(AutoFidelity, NeedsMoreRunsWhereNoNeighbourIsOfTheSameClass) {
  const json one = {{"name", "one"}, {"grid", {{"v_imp_cm_per_s", {15}}, {"theta_imp_deg", {10}}}}};
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity alone(sweep_at("sketch", one), sweep_at("survey", one), {});
  run_out(alone, connection, [](const Scene&) { return false; });
  EXPECT_EQ(cell_at(alone, 15).sketch.size(), 4u);
  EXPECT_FALSE(alone.in_doubt(cell_at(alone, 15)));
}

TEST(AutoFidelity, TakesForNeighboursWhatIsOneStepOfSpeedOrAngleAway) {
  const AutoFidelity campaign = new_campaign();  // 2 angles by 4 speeds; speeds vary fastest
  EXPECT_THAT(campaign.cells()[0].neighbours, testing::UnorderedElementsAre(1, 4));
  EXPECT_THAT(campaign.cells()[5].neighbours, testing::UnorderedElementsAre(1, 4, 6));
  const json other = {{"name", "q"}, {"grid", {{"q", {0.5, 1}}, {"v_imp_cm_per_s", {15, 18}}}}};
  const AutoFidelity two(sweep_at("sketch", other), sweep_at("survey", other), {});
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
  EXPECT_LT(fewest, most / 2);
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
  ASSERT_EQ(clear.fidelity, "sketch");
  const db::NewJob job = sweeps::new_job(clear.survey_scene);
  const std::int64_t sweep = db::add_sweep(connection, "more", "{}", std::vector{job}).sweep;
  const std::int64_t id = db::jobs(connection, {sweep}).front().id;
  db::begin_attempts(connection, std::vector{db::Start{id, "here", "", "1"}});
  db::finish(connection, id, test::ended(db::ExitReason::finished), outcome_of(clear.survey_scene),
             {});
  campaign.update(connection);
  EXPECT_EQ(cell_at(campaign, 15).survey.size(), 1u);
  EXPECT_EQ(cell_at(campaign, 15).fidelity, "sketch");
  EXPECT_TRUE(campaign.next().empty());
}

TEST(AutoFidelity, EndsWhereRunsFail) {
  const test::TemporaryFolder folder;
  db::Connection connection(folder / "a.sqlite", db::Access::write);
  AutoFidelity campaign = new_campaign();
  run_out(campaign, connection, [](const Scene& s) {
    return s.impact.v_imp_cm_per_s == 15 && s.impact.theta_imp_deg == 10;
  });
  EXPECT_TRUE(campaign.cells().front().fidelity.empty());
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
  EXPECT_THAT([&] { AutoFidelity(sweep_at("sketch", seeds), sweep_at("survey", seeds), {}); },
              ThrowsMessage<InputError>(HasSubstr("numerics.seed")));
}

}  // namespace
}  // namespace eerie::auto_fidelity
