#include "campaign/manager/manager.hpp"

#include <gmock/gmock.h>

#include <deque>
#include <fstream>

#include "campaign/job_folder/worker_exit.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/sweeps/job.hpp"
#include "db/jobs/control.hpp"
#include "db/views/query.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/sha256.hpp"
#include "tests/campaign/job_folder/job_files.hpp"
#include "tests/campaign/manager/scripted_workers.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::manager {
namespace {
using nlohmann::json;
using test::Act;
using test::ManagerOn;
using test::request;
using test::ScriptedWorkers;

TEST_F(ManagerOn, HealthyWorkersFinishesEveryJobOnce) {
  ScriptedWorkers workers({});
  const CampaignView view = work(workers);
  EXPECT_EQ(view.done, 3u);
  EXPECT_EQ(workers.starts, 3);
  EXPECT_EQ(db::results(connection, {}).size(), 3u);
  ScriptedWorkers again({});
  EXPECT_EQ(work(again).done, 3u);
  EXPECT_EQ(again.starts, 0);
}

TEST_F(ManagerOn, ANumericalFailureGivesUpAtOnceWithTheDiagnosis) {
  ScriptedWorkers workers({Act::fail});
  const CampaignView view = work(workers);
  EXPECT_EQ(view.failed, 1u);
  EXPECT_EQ(view.done, 2u);
  EXPECT_EQ(workers.starts, 3);
  const auto causes = db::failures(connection, sweep);
  ASSERT_EQ(causes.size(), 1u);
  EXPECT_EQ(causes[0].kind, "not-finite");
  EXPECT_THAT(causes[0].example_message, testing::HasSubstr("density is NaN"));
}

TEST_F(ManagerOn, ACrashTriesAgain) {
  ScriptedWorkers workers({Act::crash, Act::crash});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(workers.starts, 5);
}

TEST_F(ManagerOn, ThreeCrashesOfOneJobGiveItUp) {
  add(1);
  sweep = db::add_sweep(connection, "one", "{}", std::vector{sweeps::new_job(scenes.back())}).sweep;
  ScriptedWorkers workers({Act::crash, Act::crash, Act::crash});
  EXPECT_EQ(work(workers).failed, 1u);
  EXPECT_EQ(workers.starts, 3);
  EXPECT_EQ(db::failures(connection, sweep).at(0).kind, "signal 9");
}

TEST_F(ManagerOn, AFailedJobThatIsRetriedForgetsItsFailure) {
  ScriptedWorkers workers({Act::fail});
  work(workers);
  db::retry_failed(connection, sweep);
  ScriptedWorkers again({});
  EXPECT_EQ(work(again).done, 3u);
  EXPECT_EQ(again.starts, 1);
}

TEST_F(ManagerOn, ATornResultIsNotTakenForOne) {
  ScriptedWorkers workers({Act::tear_result});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(workers.starts, 4);
}

TEST_F(ManagerOn, ARequestToStopStartsNothingMore) {
  ScriptedWorkers workers({});
  EXPECT_EQ(work(workers, 1).done, 0u);
  EXPECT_EQ(workers.starts, 0);
  EXPECT_EQ(workers.stops, 1);
  EXPECT_EQ(in_state(db::JobState::pending), 3u);
}

TEST_F(ManagerOn, ARequestToStopLeavesWorkersAloneThatOutliveIt) {
  ScriptedWorkers workers({Act::wait, Act::wait});
  Manager manager(connection, workers, {.sweep = sweep, .leaves_workers = true});
  manager.run([&] { return manager.view().running == 2 ? 1 : 0; }, [](const CampaignView&) {});
  EXPECT_EQ(workers.stops + workers.kills, 0);
  EXPECT_EQ(in_state(db::JobState::running), 2u);
  EXPECT_EQ(in_state(db::JobState::pending), 1u);
}

TEST_F(ManagerOn, AWorkerThatWasStoppedGoesOnNextTime) {
  ScriptedWorkers workers({Act::stop});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(workers.starts, 4);
  EXPECT_EQ(db::jobs(connection, {}).at(0).crashes, 0);
}

TEST_F(ManagerOn, AResultThatAKilledManagerDidNotNoteTakesIt) {
  const db::Job job = db::jobs(connection, {}).at(0);
  db::begin_attempts(connection, std::vector{db::Start{job.id, "here", "1", "0.1.0"}});
  for (const Scene& scene : scenes)
    if (scene_hash(scene) == job.hash) test::install_result(directory(scene), scene);
  ScriptedWorkers workers({});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(workers.starts, 2);
}

TEST_F(ManagerOn, AResultOfAJobThatIsStillPendingTakesIt) {
  test::install_result(directory(scenes[1]), scenes[1]);
  ScriptedWorkers workers({});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(workers.starts, 2);
}

TEST_F(ManagerOn, ARunningJobWithoutAWorkerStartsItAgainWithoutBlame) {
  const db::Job job = db::jobs(connection, {}).at(0);
  db::begin_attempts(connection, std::vector{db::Start{job.id, "here", "1", "0.1.0"}});
  ScriptedWorkers workers({});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(workers.starts, 3);
  EXPECT_EQ(db::jobs(connection, {}).at(0).crashes, 0);
}

TEST_F(ManagerOn, HalfWrittenFilesOfTheKilledRemovesThem) {
  const auto leave_half = [&](const Scene& scene, const char* name) {
    std::filesystem::create_directories(directory(scene).path);
    std::ofstream(directory(scene).path / name) << "ha";
  };
  leave_half(scenes[0], ".scene.json.77.tmp");  // a manager's, of a job still pending
  test::install_result(directory(scenes[1]), scenes[1]);
  leave_half(scenes[1], ".ended.json.78.tmp");  // a worker's, whose job was done
  ScriptedWorkers workers({});
  EXPECT_EQ(work(workers).done, 3u);
  for (const Scene& scene : scenes)
    EXPECT_THAT(half_written_files(directory(scene).path), testing::IsEmpty());
}

TEST_F(ManagerOn, HalfWrittenFilesOfAWorkerAtWorkLeavesThemAlone) {
  std::filesystem::create_directories(directory(scenes[0]).path);
  const auto half = directory(scenes[0]).path / ".checkpoint.hdf5.77.tmp";
  std::ofstream(half) << "ha";
  auto at_work = std::make_unique<job_folder::WorkerLock>(directory(scenes[0]));
  ScriptedWorkers workers({});
  Manager manager(connection, workers, {.sweep = sweep});
  bool was_there = true;
  manager.run([] { return 0; },
              [&](const CampaignView& view) {
                if (view.done < 2 || !at_work) return;
                was_there = std::filesystem::exists(half);
                test::install_result(directory(scenes[0]), scenes[0]);
                at_work.reset();
              });
  EXPECT_TRUE(was_there);
  EXPECT_FALSE(std::filesystem::exists(half));
}

TEST_F(ManagerOn, AWorkerLeftBehindByAnotherManagerIsWaitedForAndNotDoubled) {
  const Scene& scene = scenes[0];
  std::filesystem::create_directories(directory(scene).path);
  auto left_behind = std::make_unique<job_folder::WorkerLock>(directory(scene));
  ScriptedWorkers workers({});
  Manager manager(connection, workers, {.sweep = sweep});
  int rounds = 0;
  manager.run([] { return 0; },
              [&](const CampaignView& view) {
                if (view.done < 2 || ++rounds < 2) return;
                if (left_behind) {
                  test::install_result(directory(scene), scene);
                  left_behind.reset();
                }
              });
  EXPECT_EQ(manager.view().done, 3u);
  EXPECT_EQ(workers.starts, 2);
}

TEST_F(ManagerOn, AFullDiskTriesAgainWithoutBlame) {
  ScriptedWorkers workers({Act::disk_full});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(workers.starts, 4);
  EXPECT_EQ(db::jobs(connection, {}).at(0).crashes, 0);
}

TEST_F(ManagerOn, TooLittleRoomStartsNothingAndSaysWhy) {
  ScriptedWorkers workers({});
  Manager manager(connection, workers,
                  {.sweep = sweep, .least_free_bytes = std::uintmax_t{1} << 62});
  int rounds = 0;
  CampaignView seen;
  manager.run([&] { return ++rounds > 3 ? 1 : 0; }, [&](const CampaignView& view) { seen = view; });
  EXPECT_EQ(workers.starts, 0);
  EXPECT_THAT(seen.waiting_for, testing::HasSubstr("disk full"));
}

TEST_F(ManagerOn, AWorkerThatVanishedAtWorkCountsAsCrashed) {
  ScriptedWorkers workers({Act::vanish});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(db::jobs(connection, {}).at(0).crashes, 1);
}

TEST_F(ManagerOn, AnEngineThatIsAwayWaitsForIt) {
  ScriptedWorkers workers({});
  workers.refusals = 1;
  Manager manager(connection, workers, {.sweep = sweep});
  bool waited = false;
  manager.run([&] { return waited ? 1 : 0; },
              [&](const CampaignView& view) {
                if (!view.waiting_for.empty()) waited = true;
              });
  EXPECT_TRUE(waited);
  EXPECT_EQ(in_state(db::JobState::pending), 3u);
}

TEST_F(ManagerOn, ARequestToPauseStopsWorkersAndStartsNoMore) {
  ScriptedWorkers workers({Act::wait, Act::wait});
  Manager manager(connection, workers, {.sweep = sweep});
  bool asked = false;
  manager.run([] { return 0; },
              [&](const CampaignView& view) {
                if (view.running == 2 && !std::exchange(asked, true))
                  Inbox(connection.path()).put(request("pause"));
              });
  EXPECT_EQ(workers.stops, 1);
  EXPECT_EQ(workers.starts, 2);
  EXPECT_EQ(db::count_jobs(connection, sweep).paused, 3u);
  apply(connection, request("resume"));
  ScriptedWorkers again({});
  EXPECT_EQ(work(again).done, 3u);
}

TEST_F(ManagerOn, ARequestToCancelStopsTheJobForGood) {
  ScriptedWorkers workers({Act::wait});
  Manager manager(connection, workers, {.sweep = sweep});
  bool asked = false;
  manager.run([] { return 0; },
              [&](const CampaignView& view) {
                if (view.done == 2 && !std::exchange(asked, true))
                  Inbox(connection.path()).put(request("cancel"));
              });
  EXPECT_EQ(in_state(db::JobState::cancelled), 1u);
  EXPECT_EQ(in_state(db::JobState::done), 2u);
}

TEST_F(ManagerOn, WorkSubmittedInTheMeantimeDoesItToo) {
  ScriptedWorkers workers({});
  Manager manager(connection, workers, {.stays = true});
  bool asked = false;
  manager.run([&] { return manager.view().done == 5 ? 1 : 0; },
              [&](const CampaignView& view) {
                if (view.done < 3 || std::exchange(asked, true)) return;
                Request more = request("submit");
                more.sweep = R"({"name": "more", "grid": {"v_imp_cm_per_s": [18, 19]}})";
                Inbox(connection.path()).put(more);
              });
  EXPECT_EQ(db::jobs(connection, {std::nullopt, db::JobState::done}).size(), 5u);
}

TEST_F(ManagerOn, AJobOverItsWallLimitFailsWithTheReasonAndCanBeRetried) {
  Request limit = request("wall-limit");
  limit.wall_limit_s = 0.5;
  apply(connection, limit);
  ScriptedWorkers workers({Act::wait});
  EXPECT_EQ(work(workers).failed, 1u);
  const auto causes = db::failures(connection, sweep);
  ASSERT_EQ(causes.size(), 1u);
  EXPECT_EQ(causes[0].kind, "wall-limit");
  apply(connection, request("retry"));
  ScriptedWorkers again({});
  EXPECT_EQ(work(again).done, 3u);
}

TEST_F(ManagerOn, ResultsOfAnOlderSolverKeepsThemStaleUntilARerunIsAskedFor) {
  ScriptedWorkers workers({Act::old_solver});
  EXPECT_EQ(work(workers).done, 3u);
  const auto stale = [&] {
    return std::ranges::count_if(db::results(connection, {}), &db::ResultRow::stale);
  };
  EXPECT_EQ(stale(), 1);
  ScriptedWorkers nothing({});
  work(nothing);
  EXPECT_EQ(nothing.starts, 0);
  EXPECT_EQ(apply(connection, request("rerun-stale")).at("jobs"), 1);
  ScriptedWorkers again({});
  EXPECT_EQ(work(again).done, 3u);
  EXPECT_EQ(again.starts, 1);
  EXPECT_EQ(stale(), 0);
}

TEST_F(ManagerOn, AWorkerThatAnEarlierManagerLeftIsJudgedByItsOwnWord) {
  const db::Job job = db::jobs(connection, {}).at(0);
  db::begin_attempts(connection, std::vector{db::Start{job.id, "here", "1", "0.1.0"}});
  const job_folder::JobDirectory left = job_folder::job_folder(connection).of(job.hash);
  std::filesystem::create_directories(left.path);
  install_text(left.ended(),
               job_folder::to_json(job_folder::AttemptEnded{139, 2.0, 1000, "there", 7}).dump());
  ScriptedWorkers workers({});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(db::jobs(connection, {.selection = {.hashes = {job.hash}}}).at(0).crashes, 1);
  const db::AttemptRow row = db::attempts(connection, job.id).at(0);
  EXPECT_EQ(row.host, "there");
  EXPECT_EQ(row.core_seconds, 2.0);
  EXPECT_EQ(row.peak_memory_bytes, 1000);
  EXPECT_EQ(row.failure_kind, "signal 11");
}

TEST_F(ManagerOn, AnotherFolderForJobDirectoriesWorksThere) {
  job_folder::choose_job_folder(connection, folder / "elsewhere");
  ScriptedWorkers workers({});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_FALSE(std::filesystem::exists(connection.path().string() + ".jobs"));
  EXPECT_THROW(job_folder::choose_job_folder(connection, folder / "third"), InputError);
}

}  // namespace
}  // namespace eerie::manager
