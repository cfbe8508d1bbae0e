#pragma once

#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

#include "campaign/manager/scheduler.hpp"
#include "campaign/slurm/cluster.hpp"
#include "campaign/slurm/live_batch.hpp"

namespace eerie::slurm {

/// Runs workers as array tasks of a Slurm cluster (docs/how-to/slurm.md). The folder of a
/// submission has everything about it and is written before sbatch is called. So a manager that was
/// killed at any instant finds its jobs again and submits none twice.
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
  void refused(std::size_t array_tasks);
  void accepted();
  std::size_t largest_array();
  std::chrono::seconds grace() const { return std::chrono::seconds(profile_.listed_within_s); }

  using Answers = std::map<std::string, std::optional<Queue>>;  ///< by cluster; nothing: silence
  void refresh();
  Answers ask_queues();
  static void show_queue(LiveBatch& batch, const Queue& queue);
  void note_silence(bool silent);
  void forget_what_is_over(const Answers& answers);
  void send_cancellations();

  SlurmProfile profile_;
  std::filesystem::path jobs_folder_, program_;
  std::shared_ptr<Commands> commands_;
  Cluster cluster_;
  std::list<LiveBatch> live_;
  std::unordered_map<std::string, int> held_;  ///< job directory -> batches that hold it
  std::vector<manager::WorkerEnd> ended_;      ///< not reported yet
  Clock::time_point next_poll_{}, refused_until_{};
  std::chrono::seconds patience_{0};  ///< after the last refusals; 0: the last one was accepted
  std::size_t array_limit_ = 0;  ///< of array tasks, where larger submissions were refused; 0: none
  bool squeue_is_silent_ = false;
};

}  // namespace eerie::slurm
