#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace eerie {

/// "impact.q" for the JSON pointer "/impact/q".
std::string dotted(std::string pointer);

/// Fields of a flat scene with their values, named by their pointers, as people read them:
/// "numerics.scheme=dual, end.time_s=30000 and 2 more". At most `most` are written out; one that
/// the scene lacks is off.
std::string field_words(const nlohmann::json& scene, const std::vector<std::string>& fields,
                        std::size_t most);

}  // namespace eerie
