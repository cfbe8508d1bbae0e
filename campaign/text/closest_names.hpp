#pragma once

#include <string>
#include <vector>

namespace eerie::text {

/// The names that a user who typed `given` most likely meant, as "a, b, c". For dotted paths their
/// last part counts as well.
std::string closest_names(const std::string& given, std::vector<std::string> names);

}  // namespace eerie::text
