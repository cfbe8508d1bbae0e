#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/manager/campaign_run.hpp"
#include "campaign/sweeps/plan.hpp"
#include "db/views/query.hpp"

namespace eerie::overview {

/// A command that runs a sweep, as it was typed.
struct TypedRun {
  std::filesystem::path sweep, database;
  sweeps::SceneChanges changes = {};
  std::vector<std::string> options = {};  ///< further words, such as "--scheduler", "slurm"
};

/// The command that runs it again with more words at its end. Empty where its sweep came through a
/// pipe.
std::string command_of(const TypedRun& run, const std::string& more = "");

/// What someone can type or write next. A shell takes a command as it stands.
struct NextStep {
  std::string purpose, command;
};

/// Steps after the run of a sweep. Stopped, failed and unsettled impacts come first, then the
/// elongated remnant or the impact nearest to one, then map, facts, and the next finer fidelity.
/// `jobs` is the folder in which unsettled impacts may have kept what `extend` goes on from.
std::vector<NextStep> next_steps(const TypedRun& run, const sweeps::Plan& plan,
                                 const manager::Tally& tally,
                                 const std::vector<db::ResultRow>& results,
                                 const job_folder::JobFolder& jobs);

/// Lines for people, and a list for programs.
std::string text_of(const std::vector<NextStep>& steps);
nlohmann::json to_json(const std::vector<NextStep>& steps);

}  // namespace eerie::overview
