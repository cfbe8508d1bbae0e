#pragma once

#include "campaign/job_folder/job_directory.hpp"
#include "solver/base/error.hpp"

namespace eerie::job_folder {

/// Thrown where another process works in the job directory.
struct DirectoryBusy : EnvironmentError {
  using EnvironmentError::EnvironmentError;
};

/// The lock of the process that works in a job directory, a flock on worker.lock. So two processes
/// never work in one directory, and a restarted manager sees whether its former worker still runs.
class WorkerLock {
 public:
  /// Takes the lock. Throws DirectoryBusy where another process works in the directory.
  explicit WorkerLock(const JobDirectory& directory);
  ~WorkerLock();
  WorkerLock(const WorkerLock&) = delete;
  WorkerLock& operator=(const WorkerLock&) = delete;

  static bool held(const JobDirectory& directory);

 private:
  int descriptor_;
};

}  // namespace eerie::job_folder
