#pragma once

#include <string>
#include <vector>

namespace eerie::text {

/// The names that a user who typed `given` most likely meant, as "a, b, c". For dotted paths their
/// last part counts as well, and other words for them (campaign/text/synonyms.hpp).
std::string closest_names(const std::string& given, std::vector<std::string> names);

/// Those of them that `given` means or nearly spells, the best one first; none where it is far from
/// all. Dashes in front do not count.
std::vector<std::string> likely_names(const std::string& given, std::vector<std::string> names);

}  // namespace eerie::text
