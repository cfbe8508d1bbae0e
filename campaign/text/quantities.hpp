#pragma once

#include <string>

namespace eerie::text {

/// "3 min 20 s", "2.5 h": for people.
std::string duration(double seconds);

/// "1.9e+06" as "1.9 M": for people.
std::string magnitude(double number);

/// "1 job", "2 jobs".
std::string count_of(std::size_t number, const std::string& thing);

}  // namespace eerie::text
