#pragma once

#include <filesystem>

namespace eerie::slurm {

struct ArrayTaskOptions {
  std::filesystem::path batch;  ///< its folder
  int index = 0;                ///< SLURM_ARRAY_TASK_ID
  int threads = 1;              ///< SLURM_CPUS_PER_TASK
};

/// Index and threads as Slurm tells them. Throws InputError where it does not.
ArrayTaskOptions array_task_options(std::filesystem::path batch);

/// What runs on a node: the jobs of one array task, one after another, each as a worker of its
/// own. On USR1, TERM or INT the worker writes its checkpoint and no further one is started.
/// Returns the exit code.
int run_array_task(const ArrayTaskOptions& options);

}  // namespace eerie::slurm
