#pragma once

#include <string>

#include "db/connection.hpp"
#include "db/rows.hpp"

namespace eerie::cli {

/// The job whose hash begins with `word`. Throws InputError where there is none, or several.
db::Job find_job(const db::Connection& connection, const std::string& word);

}  // namespace eerie::cli
