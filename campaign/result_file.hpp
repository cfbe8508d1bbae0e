#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/analysis.hpp"
#include "campaign/job_directory.hpp"
#include "db/rows.hpp"
#include "solver/step/run.hpp"

namespace eerie {

/// The content of result.json (docs/job-directory.md): what the impact left behind, what the
/// run cost, and where the numbers come from.
nlohmann::json result_json(const Scene& scene, const RunSummary& summary, const Analysis& analysis);

/// What a run cost and how well it kept what it must keep: the "run" part of result.json.
nlohmann::json run_json(const Scene& scene, const RunSummary& summary);

/// |L_end - L_start| / |L_start| of the whole system; nothing for a head-on impact, which has no
/// angular momentum to compare with.
std::optional<double> angular_momentum_drift(const Scene& scene, const Totals& start,
                                             const Totals& end);

/// A result as the database takes it.
struct StoredResult {
  db::Result result;
  std::vector<db::Remnant> remnants;
};

/// Reads result.json. Nothing where it is missing, torn, or belongs to another scene than `hash`.
std::optional<StoredResult> read_result(const JobDirectory& directory, const std::string& hash);

}  // namespace eerie
