#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/text/table.hpp"
#include "db/jobs/jobs.hpp"

namespace eerie::overview {

/// The cost of jobs on the machine of a database.
struct Estimate {
  std::size_t unknown = 0;  ///< jobs that the database does not have
  double core_hours = 0;    ///< for all jobs
  double speed = 0;         ///< particle-steps per second and core
  bool measured = false;  ///< whether the database has measured the speed; it is assumed otherwise
};
Estimate estimate(const std::filesystem::path& database, const std::vector<db::NewJob>& jobs);

/// The fidelity of jobs, their cost, and what a cheaper one would take, in one line.
std::string cost_sentence(const std::filesystem::path& database,
                          const std::vector<db::NewJob>& jobs);

/// A table with one row per job.
text::Table table_of_jobs(const std::vector<db::NewJob>& jobs);

}  // namespace eerie::overview
