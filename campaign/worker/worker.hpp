#pragma once

#include <filesystem>
#include <functional>

#include "analysis/remnants/analysis.hpp"
#include "solver/run/run.hpp"

namespace eerie::worker {

struct WorkerOptions {
  std::filesystem::path directory;
  int threads = 1;
  long parent = 0;  ///< process with which this one ends; 0: none
};

/// Runs the job of a directory to its result.json or failure.json, or until a stop is requested. It
/// communicates through files only. Returns the exit code.
int run_worker(const WorkerOptions& options);

/// The run and the analysis of one impact. compute() writes the history into the folder, but no
/// lock, log or result file. Where `bodies` names a folder, bodies at rest are taken from it and
/// left there.
struct Computed {
  run::RunSummary summary;
  remnants::Analysis analysis;
};
Computed compute(const Scene& scene, const std::filesystem::path& directory, int threads,
                 long max_steps, const std::function<void(const run::Progress&)>& on_progress,
                 const std::filesystem::path& bodies = {});

}  // namespace eerie::worker
