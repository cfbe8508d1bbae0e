#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "db/store/connection.hpp"

namespace eerie::maps {

/// One line for each of these settings of a database. It has the option that chooses them,
/// --fidelity NAME or --settings N, and the fields that differ from the others.
std::string settings_choices(const db::Connection& connection, const std::set<std::int64_t>& ids);

/// Throws InputError with these lines where there are several settings.
void require_one_settings(const db::Connection& connection, const std::set<std::int64_t>& ids);

}  // namespace eerie::maps
