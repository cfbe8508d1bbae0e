#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/results/run_records.hpp"
#include "db/views/query.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::results {

/// A run of a study, which has a member `scene`, with its result.
template <class Run>
struct RunWithResult {
  Run run;
  db::ResultRow row;                   ///< has only hash and result for a known run
  std::vector<db::Remnant> remnants;   ///< the most massive first
  std::optional<double> core_seconds;  ///< processor time, s
  /// The remnants at the time of the published measurement; empty where they are not known.
  std::vector<db::Remnant> at_published = {};
  std::optional<double> published_at_s = {};  ///< that time
};

/// The runs among `runs` whose result is in the database (which may be null) or among the known
/// runs.
template <class Run>
std::vector<RunWithResult<Run>> finished_runs(const std::vector<Run>& runs,
                                              const db::Connection* database,
                                              const RunRecords& known = {}) {
  std::map<std::string, db::ResultRow> rows;
  if (database != nullptr)
    for (db::ResultRow& row : db::results(*database, {})) rows.emplace(row.hash, std::move(row));
  std::vector<RunWithResult<Run>> results;
  for (const Run& run : runs) {
    const std::string hash = scene_hash(run.scene);
    if (const auto row = rows.find(hash); row != rows.end()) {
      results.push_back({run, row->second, db::remnants(*database, row->second.job),
                         db::core_seconds(*database, row->second.job)});
    } else if (const auto record = known.find(hash); record != known.end()) {
      db::ResultRow told;
      told.hash = hash;
      told.result = record->second.result;
      results.push_back({run, told, record->second.remnants, record->second.core_seconds,
                         record->second.at_published, record->second.published_at_s});
    }
  }
  return results;
}

}  // namespace eerie::results
