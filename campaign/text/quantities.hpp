#pragma once

#include <string>

namespace eerie::text {

/// A duration in s, for people: "3 min 20 s", "2.5 h".
std::string duration(double seconds);

/// A large number, for people: "1.9 M" for 1.9e6.
std::string magnitude(double number);

/// A number of things: "1 job", "2 jobs".
std::string count_of(std::size_t number, const std::string& thing);

}  // namespace eerie::text
