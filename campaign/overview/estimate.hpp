#pragma once

#include <filesystem>
#include <vector>

#include "campaign/text/table.hpp"
#include "db/jobs/jobs.hpp"

namespace eerie::overview {

/// What jobs would cost on the machine of a database.
struct Estimate {
  std::size_t unknown = 0;  ///< jobs that the database does not hold
  double core_hours = 0;    ///< of all
  double speed = 0;         ///< particle-steps per second and core
  bool measured = false;    ///< in the database; else assumed
};
Estimate estimate(const std::filesystem::path& database, const std::vector<db::NewJob>& jobs);

/// A row for each job.
text::Table table_of_jobs(const std::vector<db::NewJob>& jobs);

}  // namespace eerie::overview
