#pragma once

#include "campaign/job_folder/job_directory.hpp"
#include "solver/base/error.hpp"

namespace eerie::job_folder {

/// Another process works in the job directory.
struct DirectoryBusy : EnvironmentError {
  using EnvironmentError::EnvironmentError;
};

/// Held by the process that works in a job directory, by flock on worker.lock: two never work in
/// one, and a manager that was restarted sees whether the worker it left behind is still there.
class WorkerLock {
 public:
  /// Throws DirectoryBusy where another process works in the directory.
  explicit WorkerLock(const JobDirectory& directory);
  ~WorkerLock();
  WorkerLock(const WorkerLock&) = delete;
  WorkerLock& operator=(const WorkerLock&) = delete;

  static bool held(const JobDirectory& directory);

 private:
  int descriptor_;
};

}  // namespace eerie::job_folder
