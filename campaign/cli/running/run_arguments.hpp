#pragma once

#include <filesystem>
#include <vector>

#include "campaign/cli/options/options.hpp"
#include "campaign/cli/options/scheduler_options.hpp"

namespace eerie::cli {

struct RunArguments {
  std::filesystem::path sweep, database;
  manager::Share share;
  SceneChanges changes;
  std::vector<std::filesystem::path> maps;  ///< besides the two beside the database
  bool retry_failed = false;
  SchedulerArguments scheduler;
  // --fidelity auto; 0: its default
  double confidence = 0, core_hours = 0;
  std::int64_t most_seeds = 0;
};

/// `eerie run` with --fidelity auto.
Answer run_auto(const RunArguments& arguments, Output& out);

}  // namespace eerie::cli
