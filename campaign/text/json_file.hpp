#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace eerie::text {

/// Strict JSON: a key given twice in one object, nesting deeper than 32 and anything after the
/// document are refused. Throws InputError as "<name>, line 3, column 7: ... expected ...".
nlohmann::json parse_json(std::string_view text, const std::string& name);

/// parse_json of a plain file. A pipe in its place is refused, since reading one may wait for ever.
/// Throws InputError also where it cannot be read.
nlohmann::json load_json(const std::filesystem::path& path);

/// parse_json of what the user named: a file, a pipe, or "-" for standard input (given_file.hpp).
nlohmann::json load_given_json(const std::filesystem::path& path);

/// Reads a whole number of a document from elsewhere (int, long, unsigned long). Throws
/// json::out_of_range where it is none or does not fit: the library converts it all the same, and a
/// float out of range to anything.
template <class Whole>
void read_whole(const nlohmann::json& value, Whole& into);

}  // namespace eerie::text
