#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/worker_exit.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/manager/manager.hpp"
#include "campaign/sweeps/job.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/sha256.hpp"
#include "tests/campaign/job_folder/job_files.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::test {
using namespace manager;
using nlohmann::json;

/// What the next worker does with its directory. One that waits goes on until it is stopped.
enum class Act {
  succeed,
  fail,
  crash,
  stop,
  tear_result,
  disk_full,
  vanish,
  wait,
  old_solver,
  unreadable
};

/// Has a result say that another solver version made it, with a checksum that fits.
inline void forge_version(const job_folder::JobDirectory& directory, const std::string& version) {
  json document = json::parse(read_file(directory.result()));
  document["provenance"]["solver_version"] = version;
  document.erase("sha256");
  document["sha256"] = sha256_hex(document.dump());
  install_text(directory.result(), document.dump());
}

/// Workers that end at once, each as its script says.
class ScriptedWorkers : public Scheduler {
 public:
  explicit ScriptedWorkers(std::deque<Act> script) : script_(std::move(script)) {}

  std::size_t free_slots() override { return 2 - ended_.size() - waiting_.size(); }
  std::vector<std::string> start(std::span<const Task> tasks) override {
    if (refusals > 0) --refusals, throw SchedulerUnavailable("the scheduler is away");
    std::vector<std::string> names;
    for (const Task& task : tasks) begin(task.job, task.directory), names.emplace_back("4711");
    return names;
  }
  bool holds(const Task& task) override { return job_folder::WorkerLock::held(task.directory); }
  std::vector<WorkerEnd> wait(std::chrono::milliseconds) override {
    return std::exchange(ended_, {});
  }
  void stop(std::span<const Task> tasks, StopKind kind) override {
    ++(kind == StopKind::at_once ? kills : stops);
    for (const Task& task : tasks)
      if (std::erase(waiting_, task.job) > 0) {
        WorkerEnd end;
        end.job = task.job;
        end.exit_code = job_folder::worker_stopped;
        ended_.push_back(end);
      }
  }

  int starts = 0, stops = 0, kills = 0, refusals = 0;

 private:
  void begin(std::int64_t job, const job_folder::JobDirectory& directory) {
    ++starts;
    const Scene scene = parse_scene(json::parse(read_file(directory.scene())));
    const Act act = script_.empty() ? Act::succeed : script_.front();
    if (!script_.empty()) script_.pop_front();
    WorkerEnd end;
    end.job = job;
    end.core_seconds = 1;
    switch (act) {
      case Act::succeed:
        install_result(directory, scene);
        end.exit_code = 0;
        break;
      case Act::fail:
        install_text(
            directory.failure(),
            job_folder::to_json(job_folder::Failure{"not-finite", 12, 34, "density is NaN"})
                .dump());
        end.exit_code = 1;
        break;
      case Act::crash:
        end.signal = 9;
        break;
      case Act::stop:
        end.exit_code = job_folder::worker_stopped;
        break;
      case Act::disk_full:
        end.exit_code = job_folder::worker_disk_full;
        break;
      case Act::vanish:
        install_text(directory.heartbeat(), "{}");
        end.lost = true;
        break;
      case Act::wait:
        install_text(directory.heartbeat(), "{}");
        waiting_.push_back(job);
        return;
      case Act::old_solver:
        install_result(directory, scene);
        forge_version(directory, "0.0.1");
        end.exit_code = 0;
        break;
      case Act::unreadable:  // a regular file that opens and gives an error, to root as well
        std::filesystem::create_symlink("/proc/self/mem", directory.result());
        end.exit_code = 0;
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
  std::vector<std::int64_t> waiting_;
};

class ManagerOn : public testing::Test {
 protected:
  void SetUp() override { add(3); }

  void add(int count) {
    std::vector<db::NewJob> jobs;
    for (int i = 0; i < count; ++i) {
      scenes.push_back(parse_scene({{"numerics", {{"seed", i}}}}));
      jobs.push_back(sweeps::new_job(scenes.back()));
    }
    sweep = db::add_sweep(connection, "s", "{}", jobs).sweep;
  }
  CampaignView work(ScriptedWorkers& workers, int stop_requests = 0) {
    Manager manager(connection, workers, {.sweep = sweep});
    manager.run([&] { return stop_requests; }, [](const CampaignView&) {});
    return manager.view();
  }
  job_folder::JobDirectory directory(const Scene& scene) {
    return job_folder::job_folder(connection).of(scene_hash(scene));
  }
  std::size_t in_state(db::JobState state) { return db::jobs(connection, {sweep, state}).size(); }

  TemporaryFolder folder;
  db::Connection connection{folder / "a.sqlite", db::Access::write};
  std::vector<Scene> scenes;
  std::int64_t sweep = 0;
};

/// A request with a new id.
inline Request request(const std::string& kind, const db::Selection& selection = {}) {
  Request r;
  r.id = new_request_id();
  r.kind = kind;
  r.selection = selection;
  return r;
}

}  // namespace eerie::test
