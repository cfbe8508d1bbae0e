#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "db/store/connection.hpp"

namespace eerie::db {

/// When and where a worker was at work, and on what. Times are UTC, ISO 8601.
struct WorkSpan {
  std::string hash, host, worker, started;
  std::string ended;        ///< empty: at work
  std::string exit_reason;  ///< empty: at work
  std::string failure_kind;
};

/// The newest attempts of all jobs, at most so many, the newest first.
std::vector<WorkSpan> newest_work(const Connection& connection, std::size_t most);

}  // namespace eerie::db
