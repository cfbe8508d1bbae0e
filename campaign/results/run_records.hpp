#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/jobs/rows.hpp"

namespace eerie::results {

/// A run in the table of a study (`runs.csv` of a convergence study, `-runs.csv` of a cost study).
struct RunRecord {
  db::Result result;
  std::vector<db::Remnant> remnants;  ///< the remnants that have columns, the most massive first
  std::optional<double> core_seconds;
  std::vector<db::Remnant> at_published;  ///< the remnants at the time of the published measurement
  std::optional<double> published_at_s;   ///< that time, s after the start
};

/// Runs by the hash of their scene.
using RunRecords = std::map<std::string, RunRecord>;

/// Reads the runs of such tables, which need no repetition. Where several tables contain a run, the
/// last one counts. Throws InputError, which names file, line, column, value and mend.
RunRecords read_run_records(const std::vector<std::filesystem::path>& tables);

}  // namespace eerie::results
