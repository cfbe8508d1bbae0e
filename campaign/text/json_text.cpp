#include "campaign/text/json_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "solver/base/utf8.hpp"

namespace eerie::text {
using nlohmann::json;

namespace {

json with_escaped_bytes(const json& document) {
  if (document.is_string()) return escaped_bytes(document.get_ref<const std::string&>());
  if (!document.is_structured()) return document;
  json copy = document.is_array() ? json::array() : json::object();
  for (const auto& [key, value] : document.items())
    if (document.is_array())
      copy.push_back(with_escaped_bytes(value));
    else
      copy[escaped_bytes(key)] = with_escaped_bytes(value);
  return copy;
}

}  // namespace

std::string escaped_bytes(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    at += letter.bytes.size();
    if (letter.valid)
      out += letter.bytes;
    else
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(letter.bytes.front()));
  }
  return out;
}

std::string json_text(const json& document, int indent) {
  try {
    return document.dump(indent);
  } catch (const json::type_error&) {  // some string is no UTF-8: there is no cheaper way to know
    return with_escaped_bytes(document).dump(indent);
  }
}

}  // namespace eerie::text
