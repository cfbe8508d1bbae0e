#pragma once

#include <filesystem>
#include <vector>

#include "campaign/auto_fidelity/auto_fidelity.hpp"
#include "campaign/cli/options/options.hpp"
#include "campaign/cli/options/scheduler_options.hpp"
#include "campaign/overview/next_steps.hpp"

namespace eerie::cli {

struct RunArguments {
  std::filesystem::path sweep, database;
  manager::Share share;
  SceneChanges changes;
  std::vector<std::filesystem::path> maps;  ///< in addition to the two beside the database
  bool retry_failed = false;
  SchedulerArguments scheduler;
  // These belong to --fidelity auto alone, as its options do.
  auto_fidelity::AutoOptions automatic;
  std::string finest = "fine";
  double core_hours = 0;  ///< 0: no limit
  std::vector<const CLI::Option*> options_of_auto;
};

/// The run as it was typed, but for its budget.
overview::TypedRun typed(const RunArguments& arguments);

/// Runs `eerie run` with --fidelity auto.
Answer run_auto(const RunArguments& arguments, Output& out);

}  // namespace eerie::cli
