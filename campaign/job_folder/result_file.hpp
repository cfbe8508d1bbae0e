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

/// The version of result.json. It rises when the meaning of the file changes.
inline constexpr int result_version = 2;

/// The content of result.json (docs/reference/files.md): the analysis of the impact, the cost of the
/// run, the provenance of the numbers, and the SHA-256 of all these.
nlohmann::json result_json(const Scene& scene, const run::RunSummary& summary,
                           const remnants::Analysis& analysis);

/// The "run" part of result.json: the cost of the run and the errors of its conserved quantities.
nlohmann::json run_json(const Scene& scene, const run::RunSummary& summary);

/// A larger relative error of the angular momentum makes a warning. The usual settings keep it to
/// 1e-3 (docs/notebook/stability.md).
inline constexpr double most_angular_momentum_drift = 0.01;
/// The warnings about a run, which are also in its "run" part.
std::vector<std::string> run_warnings(const Scene& scene, const run::RunSummary& summary);

/// |L_end - L_start| / |L_start| of the whole system. Nothing for a head-on impact, which has no
/// angular momentum.
std::optional<double> angular_momentum_drift(const Scene& scene, const step::Totals& start,
                                             const step::Totals& end);

/// A result in the form that the database stores.
struct StoredResult {
  db::Result result;
  std::vector<db::Remnant> remnants;
};

/// A result from the text of its file. Nothing where the text is incomplete, has another SHA-256
/// than it says, or belongs to another scene than `hash`.
std::optional<StoredResult> parse_result(std::string_view text, const std::string& hash);

/// Reads result.json. Nothing where it is missing or does not belong to the scene.
std::optional<StoredResult> read_result(const JobDirectory& directory, const std::string& hash);

}  // namespace eerie::job_folder
