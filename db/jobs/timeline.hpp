#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "db/store/connection.hpp"

namespace eerie::db {

/// The time, host and job of a worker at work. Times are in UTC, ISO 8601.
struct WorkSpan {
  std::string hash, host, worker, started;
  std::string ended;        ///< empty while it is at work
  std::string exit_reason;  ///< empty while it is at work
  std::string failure_kind;
};

/// The newest attempts of all jobs, at most `most`, the newest first.
std::vector<WorkSpan> newest_work(const Connection& connection, std::size_t most);

}  // namespace eerie::db
