#pragma once

#include <string>
#include <vector>

#include "campaign/job_folder/job_directory.hpp"
#include "db/store/connection.hpp"

namespace eerie::manager {

/// A running job whose worker has given no sign of life for a long time.
struct Silence {
  std::string hash, host;
  double seconds = 0;
};

/// Finds silent workers. They are only reported: heartbeats carry the clock of another host, and
/// clocks jump.
std::vector<Silence> silent_jobs(const db::Connection& connection,
                                 const job_folder::JobFolder& folder);

}  // namespace eerie::manager
