#pragma once

#include <string>
#include <vector>

namespace eerie::text {

/// The names that somebody who typed `given` most likely meant, "a, b, c". Of dotted paths the
/// last part alone counts too.
std::string closest_names(const std::string& given, std::vector<std::string> names);

}  // namespace eerie::text
