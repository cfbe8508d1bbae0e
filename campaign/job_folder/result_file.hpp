#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/remnants/analysis.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "db/jobs/rows.hpp"
#include "solver/run/run.hpp"

namespace eerie::job_folder {

/// Of result.json; raised when its meaning changes.
inline constexpr int result_version = 2;

/// The content of result.json (docs/reference/files.md): what the impact left behind, what
/// the run cost, where the numbers come from, and the SHA-256 of all that.
nlohmann::json result_json(const Scene& scene, const run::RunSummary& summary,
                           const remnants::Analysis& analysis);

/// What a run cost and how well it kept what it must keep: the "run" part of result.json.
nlohmann::json run_json(const Scene& scene, const run::RunSummary& summary);

/// A run that keeps its angular momentum worse is warned of: the usual settings keep it to 1e-3
/// (docs/notebook/stability.md).
inline constexpr double most_angular_momentum_drift = 0.01;
/// What is to be said of a run beside its result; "warnings" of its "run" part.
std::vector<std::string> run_warnings(const Scene& scene, const run::RunSummary& summary);

/// |L_end - L_start| / |L_start| of the whole system; nothing for a head-on impact, which has no
/// angular momentum to compare with.
std::optional<double> angular_momentum_drift(const Scene& scene, const step::Totals& start,
                                             const step::Totals& end);

/// A result as the database takes it.
struct StoredResult {
  db::Result result;
  std::vector<db::Remnant> remnants;
};

/// A result from the text of its file. Nothing where that is torn, damaged (it has another SHA-256
/// than it says), or belongs to another scene than `hash`.
std::optional<StoredResult> parse_result(std::string_view text, const std::string& hash);

/// Reads result.json. Nothing where it is missing or no result of the scene.
std::optional<StoredResult> read_result(const JobDirectory& directory, const std::string& hash);

}  // namespace eerie::job_folder
