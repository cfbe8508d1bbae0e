#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/results/run_records.hpp"
#include "db/views/query.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::results {

/// A run of a study, which has a `scene`, with its result.
template <class Run>
struct RunWithResult {
  Run run;
  db::ResultRow row;                   ///< of a known run: hash and result alone
  std::vector<db::Remnant> remnants;   ///< from the most massive on
  std::optional<double> core_seconds;  ///< processor time, s
  /// The remnants when what is published was measured; empty where that is not known.
  std::vector<db::Remnant> at_published = {};
  std::optional<double> published_at_s = {};  ///< the time that they are of
};

/// Those of `runs` that the database (none: null) has a result of, and those that are known
/// besides.
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
