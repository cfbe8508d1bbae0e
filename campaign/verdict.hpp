#pragma once

#include <optional>
#include <string>
#include <variant>

#include "campaign/result_file.hpp"
#include "campaign/scheduler.hpp"
#include "db/connection.hpp"

namespace eerie {

/// What became of an attempt.
struct Finished {
  StoredResult stored;
};
struct Failed {  ///< for good: the same input fails again
  Failure failure;
};
struct Stopped {};  ///< on request, with a checkpoint
struct Crashed {    ///< tried again, max_crashes times
  std::string kind, message;
};
struct Lost {};  ///< its manager went away; nobody saw the end
using Verdict = std::variant<Finished, Failed, Stopped, Crashed, Lost>;

/// Attempts of one job that may crash before it counts as failed.
inline constexpr int max_crashes = 3;

/// Reads the verdict from the files; `end`, where a process was seen to end, decides only
/// between the ways to have no result.
Verdict judge(const JobDirectory& directory, const std::string& hash,
              const std::optional<WorkerEnd>& end);

/// Commits the verdict and gives the state in which the job now is.
db::JobState commit(db::Connection& connection, const db::Job& job, const Verdict& verdict,
                    const std::optional<WorkerEnd>& end, std::optional<double> particle_steps);

}  // namespace eerie
