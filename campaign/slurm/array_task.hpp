#pragma once

#include <filesystem>

namespace eerie::slurm {

struct ArrayTaskOptions {
  std::filesystem::path batch;  ///< folder of the batch
  int index = 0;                ///< SLURM_ARRAY_TASK_ID
  int threads = 1;              ///< SLURM_CPUS_PER_TASK
};

/// Reads index and threads from Slurm's environment. Throws InputError where they are missing.
ArrayTaskOptions array_task_options(std::filesystem::path batch);

/// Runs the jobs of one array task on a node, one after another, each with its own worker. On USR1,
/// TERM or INT the worker writes its checkpoint, and no further one starts. Returns the exit code.
int run_array_task(const ArrayTaskOptions& options);

}  // namespace eerie::slurm
