#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "db/jobs/job_settings.hpp"
#include "db/store/connection.hpp"

namespace eerie::results {

/// One of several settings of a database, and the fields in which it differs from the others.
struct SettingsDifference {
  db::JobSettings settings;
  std::string fields;  ///< "numerics.scheme=dual, end.time_s=30000 and 2 more"
};
std::vector<SettingsDifference> differences(const db::Connection& connection,
                                            const std::set<std::int64_t>& ids);

/// One line for each of these settings of a database. It has the option that chooses them,
/// --fidelity NAME or --settings N, and the fields that differ from the others.
std::string settings_choices(const db::Connection& connection, const std::set<std::int64_t>& ids);

/// Throws InputError with these lines where there are several settings.
void require_one_settings(const db::Connection& connection, const std::set<std::int64_t>& ids);

}  // namespace eerie::results
