#include "campaign/overview/next_steps.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::overview {
namespace {
using nlohmann::json;
using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

db::ResultRow row(double v, double theta, double b_over_a, bool settled = true) {
  db::ResultRow r;
  r.hash = "0123456789abcdef";
  r.q = 1, r.phi_d_deg = 40, r.v_imp_cm_per_s = v, r.theta_imp_deg = theta;
  r.end_time_s = 1e5, r.settings = 3;
  r.result.b_over_a = b_over_a;
  r.result.n_eer = b_over_a < 0.3 ? 1 : 0;
  r.result.settled = settled;
  return r;
}

class NextSteps : public testing::Test {
 protected:
  NextSteps() { install_text(run.sweep, "{}"); }

  /// The sweep asks for all results but those of `unasked`.
  std::vector<NextStep> steps(const json& sweep, const std::vector<db::ResultRow>& results,
                              const manager::Tally& tally = {}, const std::string& unasked = "") {
    sweeps::Plan plan = sweeps::plan(sweep, run.changes.all(), "s.json");
    for (const db::ResultRow& result : results) {
      if (result.hash == unasked) continue;
      db::NewJob job = plan.jobs.front();
      job.hash = result.hash;
      plan.jobs.push_back(job);
    }
    return next_steps(run, plan, tally, results, {folder / "jobs"});
  }
  static auto command(const std::string& text) {
    return Contains(Field(&NextStep::command, HasSubstr(text)));
  }

  test::TemporaryFolder folder;
  TypedRun run{folder / "my sweep.json", "a b.sqlite", {.fidelity = "survey"}};
  const json grid = {{"name", "s"},
                     {"grid", {{"v_imp_cm_per_s", {16, 20, 24}}, {"theta_imp_deg", {10, 15}}}}};
};

TEST_F(NextSteps, RunTheSameFurtherAfterAStopAFailureOrWithoutAnEnd) {
  const auto found = steps(grid, {row(16, 10, 0.2), row(20, 10, 0.5, false)},
                           {.total = 6, .done = 2, .failed = 1, .left = 3, .paused = 1});
  const std::string again =
      "eerie run '" + run.sweep.string() + "' --db 'a b.sqlite' --fidelity survey";
  EXPECT_EQ(found[0].command, "eerie resume --all --db 'a b.sqlite'");
  EXPECT_EQ(found[1].command, again);
  EXPECT_EQ(found[2].command, again + " --retry-failed");
  EXPECT_EQ(found[3].command,
            again + " --set end.time_s=1000000 --set end.settled.horizon_s=1000000");
  EXPECT_THAT(found, Not(command("--fidelity standard")));  // while jobs are left
}

TEST_F(NextSteps, LetImpactsGoOnThatKeptAStateBeforeTheirEnd) {
  std::vector<db::ResultRow> two = {row(16, 10, 0.5, false), row(20, 10, 0.5, false)};
  two[1].hash = "89abcdef01234567";
  const auto keep = [&](const std::string& hash) {
    const auto directory = job_folder::JobFolder{folder / "jobs"}.of(hash).path;
    std::filesystem::create_directories(directory);
    install_text(directory / "before_end.hdf5", "");
  };
  keep(two[0].hash);
  auto found = steps(grid, two);
  EXPECT_EQ(found[0].command, "eerie extend 01234567 --until 1000000 --db 'a b.sqlite'");
  EXPECT_THAT(found[0].purpose, HasSubstr("the one that has not settled"));
  EXPECT_THAT(found[1].purpose, HasSubstr("since one has not settled"));
  keep(two[1].hash);
  found = steps(grid, two);
  EXPECT_EQ(found[0].command, "eerie extend 01234567 89abcdef --until 1000000 --db 'a b.sqlite'");
  EXPECT_THAT(found, Not(Contains(Field(&NextStep::purpose, HasSubstr("compute all again")))));
  // Its end may be an axis: each goes on with its own scene.
  json ends = grid;
  run.changes.fidelity.clear();
  ends["grid"]["end.time_s"] = {1e5, 2e5};
  EXPECT_THAT(steps(ends, two), command("eerie extend 01234567"));
}

TEST_F(NextSteps, LetNothingGoOnThatHasGoneOnAlready) {
  std::vector<db::ResultRow> two = {row(20, 10, 0.5, false), row(20, 10, 0.4, false)};
  two[1].hash = "89abcdef01234567";
  for (const bool settles : {false, true}) {
    two[1].result.settled = settles;
    const auto found = steps(grid, two, {}, two[1].hash);
    EXPECT_THAT(found, Not(command("end.time_s")));
    EXPECT_THAT(found, Not(command("eerie extend")));
  }
  two.push_back(row(24, 10, 0.5, false));  // another impact has not
  EXPECT_THAT(steps(grid, two, {}, two[1].hash), command("end.time_s"));
}

TEST_F(NextSteps, AskForTwiceTheTimeWhereNothingFlies) {
  run.changes.overrides = {"numerics.rigid_flight=false"};
  EXPECT_THAT(steps(grid, {row(20, 10, 0.5, false)}),
              command("--set numerics.rigid_flight=false --set end.time_s=200000"));
}

TEST_F(NextSteps, AfterAllIsDoneAreTheEerTheMapTheFactsAndTheNextRung) {
  const auto found = steps(grid, {row(16, 10, 0.2), row(20, 10, 0.5)}, {.total = 6, .done = 6});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].command, "eerie show 01234567 --db 'a b.sqlite'");
  EXPECT_EQ(found[1].command,
            "eerie map --db 'a b.sqlite' --q 1 --phi-d 40 --settings 3 -o map.png");
  EXPECT_EQ(found[2].command, "eerie check --db 'a b.sqlite'");
  EXPECT_THAT(found[3].command, HasSubstr("--fidelity standard"));
}

TEST_F(NextSteps, WithoutAnEerGoFromTheNearestCellToAFinerGrid) {
  const auto found = steps(grid, {row(20, 10, 0.42), row(24, 15, 0.7)});
  EXPECT_THAT(found[0].purpose, HasSubstr("b/a 0.42 at 20 cm/s and 10 deg"));
  EXPECT_EQ(found[1].command, "\"v_imp_cm_per_s\": [18, 20, 22], \"theta_imp_deg\": [10, 12.5]");
  // What is given is part of a sweep.
  json finer = grid;
  finer["grid"].merge_patch(json::parse("{" + found[1].command + "}"));
  EXPECT_EQ(sweeps::plan(finer, {}, "s.json").jobs.size(), 6u);
}

TEST_F(NextSteps, NameNoCommandThatWouldBeRefused) {
  const std::vector<db::ResultRow> unsettled = {row(20, 10, 0.5, false)};
  json sweep = grid;
  sweep["grid"]["end.time_s"] = {1e5, 2e5};
  run.changes.fidelity.clear();
  EXPECT_THAT(steps(sweep, unsettled), Not(command("end.time_s")));
  sweep = grid;
  sweep["grid"]["numerics.scheme"] = {"closing-gaps", "dual"};
  EXPECT_THAT(steps(sweep, unsettled), Not(command("--fidelity")));
  std::vector<db::ResultRow> two = {row(20, 10, 0.5), row(20, 10, 0.5)};
  two[1].settings = 4;
  EXPECT_THAT(steps(grid, two), Not(command("eerie map")));
  run.sweep = "-";
  EXPECT_THAT(steps(grid, unsettled, {.failed = 1, .left = 1}), Not(command("eerie run")));
}

TEST_F(NextSteps, AreLinesForPeopleAndAListForPrograms) {
  const std::vector<NextStep> two = {{"look", "eerie show 1"}, {"map", "eerie map -o a.png"}};
  EXPECT_EQ(text_of(two), "\nnext:\n  look:\n    eerie show 1\n  map:\n    eerie map -o a.png\n");
  EXPECT_EQ(text_of({}), "");
  EXPECT_EQ(to_json(two)[1]["command"], "eerie map -o a.png");
}

}  // namespace
}  // namespace eerie::overview
