#pragma once

#include <filesystem>
#include <functional>

#include "analysis/analysis.hpp"
#include "solver/step/run.hpp"

namespace eerie {

/// Exit code of a worker that was told to stop and left a checkpoint (sysexits' EX_TEMPFAIL).
inline constexpr int worker_stopped = 75;
/// It could not write for want of room on the disk (EX_IOERR).
inline constexpr int worker_disk_full = 74;
/// Another worker is in the directory (EX_CANTCREAT).
inline constexpr int worker_busy = 73;

struct WorkerOptions {
  std::filesystem::path directory;
  int threads = 1;
  long parent = 0;  ///< process to die with; 0: none
};

/// Runs the job of a directory to its result.json or failure.json, or until told to stop.
/// Speaks through files only. Returns the exit code.
int run_worker(const WorkerOptions& options);

/// One impact in a folder: history, run and analysis, without lock, log or result file.
struct Computed {
  RunSummary summary;
  Analysis analysis;
};
Computed compute(const Scene& scene, const std::filesystem::path& directory, int threads,
                 long max_steps, const std::function<void(const Progress&)>& on_progress);

}  // namespace eerie
