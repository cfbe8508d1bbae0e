#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "analysis/remnants/analysis.hpp"
#include "campaign/job_folder/history.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "db/store/connection.hpp"

namespace eerie::worker {

/// Analyses the last snapshot of a run. It uses the first snapshot of the folder, where there is
/// one, and the history, which says whether the bodies separated after contact.
remnants::Analysis analyse_run(const job_folder::JobDirectory& directory, const io::Snapshot& last,
                               const std::vector<job_folder::HistoryRow>& history);

struct Reanalysis {
  std::size_t analysed = 0;
  std::vector<std::string> skipped;  ///< the jobs, with the reasons
};

/// Analyses the last snapshot of every finished job again and stores the findings in result.json
/// and the database. The runs do not change. It serves results of older programs, whose analysis
/// found less. The caller holds the lock of the database. `on_progress`(done, all) is called after
/// each job.
Reanalysis reanalyse(db::Connection& connection,
                     const std::function<void(std::size_t, std::size_t)>& on_progress);

}  // namespace eerie::worker
