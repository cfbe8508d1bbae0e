#pragma once

#include <optional>
#include <string>
#include <variant>

#include "campaign/job_folder/result_file.hpp"
#include "campaign/manager/scheduler.hpp"
#include "db/store/connection.hpp"

namespace eerie::manager {

/// These are the possible ends of an attempt.
struct HasResult {
  job_folder::StoredResult stored;
};
struct Failed {  ///< final, since the same input would fail again
  job_folder::Failure failure;
};
struct Stopped {};  ///< stopped on request, with a checkpoint
struct Crashed {    ///< will be tried again, max_crashes times
  std::string kind, message;
};
struct DiskFull {};  ///< could not write; the job continues once there is free space
struct Lost {};      ///< its manager went away, so nobody saw its end
using AttemptVerdict = std::variant<HasResult, Failed, Stopped, Crashed, DiskFull, Lost>;

/// The number of crashed attempts after which a job counts as failed.
inline constexpr int max_crashes = 3;

/// Reads the verdict from the files. `end`, where a worker was seen to end, only distinguishes
/// attempts without a result. Without it the last report of the worker counts.
AttemptVerdict judge_attempt(const job_folder::JobDirectory& directory, const std::string& hash,
                             const std::optional<WorkerEnd>& end);

/// An attempt that is over.
struct Attempt {
  std::optional<WorkerEnd> end = {};
  std::optional<job_folder::AttemptEnded> word = {};  ///< the last report of the worker
  std::optional<double> particle_steps = {};
  double wall_s = 0;             ///< time for which its worker was seen at work, s
  bool over_wall_limit = false;  ///< whether it was stopped for exceeding its wall limit
};

/// Commits the verdict and returns the new state of the job.
db::JobState commit(db::Connection& connection, const db::Job& job, const AttemptVerdict& verdict,
                    const Attempt& attempt);

}  // namespace eerie::manager
