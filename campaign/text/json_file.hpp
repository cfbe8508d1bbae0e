#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace eerie::text {

/// Strict JSON: a key given twice in one object, nesting deeper than 32 and anything after the
/// document are refused. Throws InputError as "<name>, line 3, column 7: ... expected ...".
nlohmann::json parse_json(std::string_view text, const std::string& name);

/// parse_json of a file that the user named. Throws InputError also where it cannot be read.
nlohmann::json load_json(const std::filesystem::path& path);

}  // namespace eerie::text
