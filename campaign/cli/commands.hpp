#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/cli/options/options.hpp"
#include "campaign/cli/options/scheduler_options.hpp"

namespace eerie::cli {

/// What the command line says, one struct per command; each function returns the exit code.

struct RunArguments {
  std::filesystem::path sweep, database;
  int workers = 0;          ///< 0: chosen
  int threads_per_job = 0;  ///< 0: chosen
  SceneChanges changes;
  std::vector<std::filesystem::path> maps;  ///< besides the two beside the database
  bool retry_failed = false;
  EngineArguments engine;
  bool json = false;
  // --fidelity auto; 0: its default
  double confidence = 0, core_hours = 0;
  std::int64_t most_seeds = 0;
};
int run(const RunArguments& arguments);
/// run() with --fidelity auto.
int run_auto(const RunArguments& arguments);

struct ExpandArguments {
  std::filesystem::path sweep, database;
  SceneChanges changes;
  bool list = false, json = false;
};
int expand(const ExpandArguments& arguments);

struct SolveArguments {
  std::filesystem::path scene, directory;
  long max_steps = 0;  ///< 0: until the end time
  int threads = 0;     ///< 0: all cores
  SceneChanges changes;
  bool json = false;
};
int solve(const SolveArguments& arguments);

}  // namespace eerie::cli
