#pragma once

#include <filesystem>
#include <list>
#include <memory>
#include <unordered_map>

#include "campaign/manager/scheduler.hpp"
#include "campaign/slurm/cluster.hpp"
#include "campaign/slurm/live_batch.hpp"

namespace eerie::slurm {

/// Runs workers as array tasks of a Slurm cluster (docs/how-to/slurm.md). The folder of a submission has
/// everything about it and is written before sbatch is called. So a manager that was killed at any
/// instant finds its jobs again and submits none twice.
class SlurmScheduler : public manager::Scheduler {
 public:
  /// Takes over the batches that an earlier manager left in `jobs_folder`, which nodes must see
  /// under the same path. `program` is the eerie that nodes run.
  SlurmScheduler(SlurmProfile profile, const std::filesystem::path& jobs_folder);
  SlurmScheduler(SlurmProfile profile, const std::filesystem::path& jobs_folder,
                 std::shared_ptr<Commands> commands, std::filesystem::path program);

  /// The free places in the queue. It returns 0 until a quarter of them is free, since a few large
  /// arrays burden Slurm less than many small ones.
  std::size_t free_slots() override;
  std::vector<std::string> start(std::span<const manager::Task> tasks) override;
  bool holds(const manager::Task& task) override;
  std::vector<manager::WorkerEnd> wait(std::chrono::milliseconds longest) override;

  /// Writes a stop file into each job directory, and cancels array tasks that have no other jobs:
  /// the waiting ones, and with at_once also the running ones.
  void stop(std::span<const manager::Task> tasks, manager::StopKind kind) override;

 private:
  using Clock = std::chrono::steady_clock;

  void adopt_batches();
  void hold(const LiveBatch& batch);
  void release(const LiveBatch& batch, const std::vector<manager::WorkerEnd>& ends);
  std::vector<std::string> submit(std::span<const std::vector<manager::Task>> packs, bool first);
  void refresh();
  void send_cancellations();

  SlurmProfile profile_;
  std::filesystem::path jobs_folder_, program_;
  std::shared_ptr<Commands> commands_;
  Cluster cluster_;
  std::list<LiveBatch> live_;
  std::unordered_map<std::string, int> held_;  ///< job directory -> number of batches that have it
  std::vector<manager::WorkerEnd> ended_;      ///< ends that are not reported yet
  Clock::time_point next_poll_{};
  bool squeue_is_silent_ = false;
};

}  // namespace eerie::slurm
