#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace eerie::text {

/// A text of any bytes, such as a path, as UTF-8: a byte that is none becomes "\xNN" (four letters,
/// two hexadecimal digits), all else stays.
std::string escaped_bytes(std::string_view text);

/// JSON text of a document whose strings may hold any bytes, escaped as escaped_bytes() says.
/// `indent`: spaces per level, or -1 for one line.
std::string json_text(const nlohmann::json& document, int indent = -1);

}  // namespace eerie::text
