#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/jobs/rows.hpp"
#include "db/store/connection.hpp"

namespace eerie::db {

// The questions of an examination to a database.

/// Rows that refer to a missing row.
std::vector<std::string> broken_references(const Connection& connection);

/// Views that somebody has changed or removed; and those made anew.
std::vector<std::string> changed_views(const Connection& connection);
void remake_views(Connection& connection);

bool has_open_attempt(const Connection& connection, std::int64_t job);

/// The numbers of a job's result that distinguish it from another result.
struct ResultMark {
  std::string outcome_class;
  std::optional<double> b_over_a;
  std::int64_t steps = 0;
};
std::optional<ResultMark> result_of(const Connection& connection, std::int64_t job);

}  // namespace eerie::db
