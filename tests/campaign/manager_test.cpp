#include "campaign/manager.hpp"

#include <gmock/gmock.h>

#include <deque>

#include "campaign/job.hpp"
#include "campaign/worker.hpp"
#include "campaign/worker_lock.hpp"
#include "db/query.hpp"
#include "tests/campaign/job_files.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie {
namespace {
using nlohmann::json;

/// What the next worker does with its directory.
enum class Act { succeed, fail, crash, stop, tear_result };

/// Workers that end at once, each as its script says.
class ScriptedWorkers : public Scheduler {
 public:
  explicit ScriptedWorkers(std::deque<Act> script) : script_(std::move(script)) {}

  std::size_t free_slots() override { return 2 - ended_.size(); }
  std::vector<std::string> start(std::span<const Task> tasks) override {
    std::vector<std::string> names;
    for (const Task& task : tasks) begin(task.job, task.directory), names.emplace_back("4711");
    return names;
  }
  bool holds(const Task& task) override { return WorkerLock::held(task.directory); }
  std::vector<WorkerEnd> wait(std::chrono::milliseconds) override {
    return std::exchange(ended_, {});
  }
  void stop(std::span<const Task>, StopKind kind) override {
    ++(kind == StopKind::at_once ? kills : stops);
  }

  int starts = 0, stops = 0, kills = 0;

 private:
  void begin(std::int64_t job, const JobDirectory& directory) {
    ++starts;
    const Scene scene = parse_scene(json::parse(read_file(directory.scene())));
    const Act act = script_.empty() ? Act::succeed : script_.front();
    if (!script_.empty()) script_.pop_front();
    WorkerEnd end;
    end.job = job;
    end.core_seconds = 1;
    switch (act) {
      case Act::succeed:
        test::install_result(directory, scene);
        end.exit_code = 0;
        break;
      case Act::fail:
        install_text(directory.failure(),
                     to_json(Failure{"not-finite", 12, 34, "density is NaN"}).dump());
        end.exit_code = 1;
        break;
      case Act::crash:
        end.signal = 9;
        break;
      case Act::stop:
        end.exit_code = worker_stopped;
        break;
      case Act::tear_result:
        install_text(directory.result(), "{\"version\": 1, ");
        end.exit_code = 0;
        break;
    }
    ended_.push_back(end);
  }

  std::deque<Act> script_;
  std::vector<WorkerEnd> ended_;
};

class ManagerOn : public testing::Test {
 protected:
  void SetUp() override { add(3); }

  void add(int count) {
    std::vector<db::NewJob> jobs;
    for (int i = 0; i < count; ++i) {
      scenes.push_back(parse_scene({{"numerics", {{"seed", i}}}}));
      jobs.push_back(new_job(scenes.back()));
    }
    sweep = db::add_sweep(connection, "s", "{}", jobs).sweep;
  }
  CampaignView work(ScriptedWorkers& workers, int stop_requests = 0) {
    Manager manager(connection, workers, {.sweep = sweep});
    manager.run([&] { return stop_requests; }, [](const CampaignView&) {});
    return manager.view();
  }
  JobDirectory directory(const Scene& scene) {
    return job_folder(connection).of(scene_hash(scene));
  }
  std::size_t in_state(db::JobState state) { return db::jobs(connection, {sweep, state}).size(); }

  test::TemporaryFolder folder;
  db::Connection connection{folder / "a.sqlite", db::Access::write};
  std::vector<Scene> scenes;
  std::int64_t sweep = 0;
};

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
  sweep = db::add_sweep(connection, "one", "{}", std::vector{new_job(scenes.back())}).sweep;
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

TEST_F(ManagerOn, AWorkerLeftBehindByAnotherManagerIsWaitedForAndNotDoubled) {
  const Scene& scene = scenes[0];
  std::filesystem::create_directories(directory(scene).path);
  auto left_behind = std::make_unique<WorkerLock>(directory(scene));
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

}  // namespace
}  // namespace eerie
