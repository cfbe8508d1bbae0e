#pragma once

#include <map>

#include "campaign/manager/scheduler.hpp"

namespace eerie::manager {

/// Runs workers as child processes: this program as `eerie worker DIR`.
class LocalProcesses : public Scheduler {
 public:
  LocalProcesses(std::size_t workers, int threads_per_job);
  ~LocalProcesses() override;  ///< kills the remaining workers

  std::size_t free_slots() override { return workers_ - jobs_.size(); }
  std::vector<std::string> start(std::span<const Task> tasks) override;
  bool holds(const Task& task) override;
  std::vector<WorkerEnd> wait(std::chrono::milliseconds longest) override;
  void stop(std::span<const Task> tasks, StopKind kind) override;

 private:
  pid_t spawn(const job_folder::JobDirectory& directory) const;
  std::vector<WorkerEnd> reap();

  std::size_t workers_;
  int threads_per_job_;
  std::map<pid_t, std::int64_t> jobs_;  ///< process id -> job
};

}  // namespace eerie::manager
