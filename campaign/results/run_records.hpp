#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/jobs/rows.hpp"

namespace eerie::results {

/// What the table of a study's runs (`runs.csv` of a convergence study, `-runs.csv` of a chart)
/// tells of one of them.
struct RunRecord {
  db::Result result;
  std::vector<db::Remnant> remnants;  ///< those with columns, from the most massive on
  std::optional<double> core_seconds;
  std::vector<db::Remnant> at_published;  ///< the same when what is published was measured,
  std::optional<double> published_at_s;   ///< that is, so long after the start
};

/// By the hash of the run's scene.
using RunRecords = std::map<std::string, RunRecord>;

/// Runs that are known from such tables, so that nobody has to repeat them; of a run that stands in
/// several the last. Throws InputError naming file, line, column, value and mend.
RunRecords read_run_records(const std::vector<std::filesystem::path>& tables);

}  // namespace eerie::results
