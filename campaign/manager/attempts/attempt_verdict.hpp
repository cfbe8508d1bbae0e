#pragma once

#include <optional>
#include <string>
#include <variant>

#include "campaign/job_folder/result_file.hpp"
#include "campaign/manager/scheduler.hpp"
#include "db/store/connection.hpp"

namespace eerie::manager {

/// What became of an attempt.
struct HasResult {
  job_folder::StoredResult stored;
};
struct Failed {  ///< for good: the same input fails again
  job_folder::Failure failure;
};
struct Stopped {};  ///< on request, with a checkpoint
struct Crashed {    ///< tried again, max_crashes times
  std::string kind, message;
};
struct DiskFull {};  ///< it could not write; the job goes on once there is room
struct Lost {};      ///< its manager went away; nobody saw the end
using AttemptVerdict = std::variant<HasResult, Failed, Stopped, Crashed, DiskFull, Lost>;

/// Attempts of one job that may crash before it counts as failed.
inline constexpr int max_crashes = 3;

/// Reads the verdict from the files; `end`, where a worker was seen to end, decides only between
/// the ways to have no result. Without it the worker's own last word counts.
AttemptVerdict judge_attempt(const job_folder::JobDirectory& directory, const std::string& hash,
                             const std::optional<WorkerEnd>& end);

/// An attempt that is over.
struct Attempt {
  std::optional<WorkerEnd> end = {};
  std::optional<job_folder::AttemptEnded> word = {};  ///< the worker's own
  std::optional<double> particle_steps = {};
  double wall_s = 0;             ///< that its worker was seen at work
  bool over_wall_limit = false;  ///< and was stopped for it
};

/// Commits the verdict and gives the state in which the job now is.
db::JobState commit(db::Connection& connection, const db::Job& job, const AttemptVerdict& verdict,
                    const Attempt& attempt);

}  // namespace eerie::manager
