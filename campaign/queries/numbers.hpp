#pragma once

#include <optional>
#include <string>

#include "db/jobs/selection.hpp"

namespace eerie::queries {

/// A whole text as a finite number, rounded to sweeps::significant_digits; nothing where it is
/// none.
std::optional<double> finite_number(const std::string& text);

/// "90s", "45min", "2h", "1.5d" in seconds. Throws InputError naming `option`, without a unit too.
double parse_duration(const std::string& text, const std::string& option);

/// "18:22" -> {18, 22}; "20" -> {20, 20}. Throws InputError naming `option`.
db::Range parse_range(const std::string& text, const std::string& option);

}  // namespace eerie::queries
