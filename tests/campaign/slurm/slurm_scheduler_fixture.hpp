#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "campaign/job_folder/worker_exit.hpp"
#include "campaign/slurm/slurm_scheduler.hpp"
#include "solver/base/file.hpp"
#include "tests/campaign/slurm/fake_slurm.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::slurm {

/// A scheduler of a cluster that answers at once and lists what it takes.
class ASlurmScheduler : public testing::Test {
 protected:
  ASlurmScheduler() {
    profile.poll_interval_s = 0;  // each call asks
    profile.minutes_per_array_task = 0;
    profile.listed_within_s = 0;
  }

  SlurmScheduler scheduler() { return {profile, folder.path(), slurm, "/opt/eerie"}; }

  std::vector<manager::Task> tasks(int count) {
    std::vector<manager::Task> made;
    for (int k = 0; k < count; ++k) {
      const job_folder::JobDirectory directory{folder.path() / fmt::format("{:016x}", k)};
      std::filesystem::create_directories(directory.path);
      made.push_back({100 + k, directory, 60});
    }
    return made;
  }
  static void finish(const manager::Task& task) { install_text(task.directory.result(), "{}"); }
  static void note(const manager::Task& task, int exit_code) {
    install_text(
        task.directory.ended(),
        job_folder::to_json(job_folder::AttemptEnded{exit_code, 12.5, 1 << 20, "n1", 4711}).dump());
  }
  std::size_t batch_folders() const {
    std::error_code none;
    const std::filesystem::directory_iterator entries(batches_folder(folder.path()), none);
    return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
  }
  std::filesystem::path batch_folder() const {
    return std::filesystem::directory_iterator(batches_folder(folder.path()))->path();
  }

  test::TemporaryFolder folder;
  std::shared_ptr<test::FakeSlurm> slurm = std::make_shared<test::FakeSlurm>();
  SlurmProfile profile;
};

}  // namespace eerie::slurm
