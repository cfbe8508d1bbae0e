#pragma once

#include <map>
#include <string>
#include <vector>

#include "db/query.hpp"
#include "solver/scene/scene.hpp"

namespace eerie {

/// A run of a study, which has a `scene`, with the result that the database has of it.
template <class Run>
struct Finished {
  Run run;
  db::ResultRow row;
  std::vector<db::Remnant> remnants;  ///< from the most massive on
  double core_seconds = 0;            ///< processor time, s
};

/// Those of `runs` that the database has a result of.
template <class Run>
std::vector<Finished<Run>> finished_runs(const db::Connection& connection,
                                         const std::vector<Run>& runs) {
  std::map<std::string, db::ResultRow> rows;
  for (db::ResultRow& row : db::results(connection, {})) rows.emplace(row.hash, std::move(row));
  std::vector<Finished<Run>> results;
  for (const Run& run : runs)
    if (const auto row = rows.find(scene_hash(run.scene)); row != rows.end())
      results.push_back({run, row->second, db::remnants(connection, row->second.job),
                         db::core_seconds(connection, row->second.job)});
  return results;
}

}  // namespace eerie
