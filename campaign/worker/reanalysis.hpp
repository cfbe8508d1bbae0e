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

/// What the last snapshot of a run says, with what its folder knows besides: the first snapshot
/// (where there is one) and whether the bodies parted after contact.
remnants::Analysis analyse_run(const job_folder::JobDirectory& directory, const io::Snapshot& last,
                               const std::vector<job_folder::HistoryRow>& history);

struct Reanalysis {
  std::size_t analysed = 0;
  std::vector<std::string> skipped;  ///< which jobs, and why
};

/// Analyses the last snapshot of every finished job again and puts what it finds into result.json
/// and the database; the runs themselves stay as they are. For results that an older program
/// wrote, whose analysis told less. The caller holds the database's lock. `on_progress`(done, all).
Reanalysis reanalyse(db::Connection& connection,
                     const std::function<void(std::size_t, std::size_t)>& on_progress);

}  // namespace eerie::worker
