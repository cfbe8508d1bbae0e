#pragma once

#include <optional>
#include <string>
#include <vector>

#include "db/jobs/selection.hpp"

namespace eerie::queries {

/// The finite number that the whole text is, rounded to sweeps::significant_digits; nothing for
/// other texts.
std::optional<double> finite_number(const std::string& text);

/// A duration in seconds from "90s", "45min", "2h" or "1.5d". Throws InputError, which names
/// `option`, for other texts and without a unit.
double parse_duration(const std::string& text, const std::string& option);

/// At most `most` times in s, none negative, from "0, 5e3,1e4". Throws InputError, which names
/// `option`.
std::vector<double> parse_times(const std::string& text, const std::string& option,
                                std::size_t most);

/// A range: "18:22" is {18, 22} and "20" is {20, 20}. Throws InputError, which names `option`.
db::Range parse_range(const std::string& text, const std::string& option);

}  // namespace eerie::queries
