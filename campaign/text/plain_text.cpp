#include "campaign/text/plain_text.hpp"

#include <fmt/format.h>

#include "solver/base/utf8.hpp"

namespace eerie::text {
namespace {

std::string escaped(char32_t code) {
  const auto number = static_cast<unsigned>(code);
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  if (number < 0x100) return fmt::format("\\x{:02x}", number);
  return number < 0x10000 ? fmt::format("\\u{:04x}", number) : fmt::format("\\U{:08x}", number);
}

std::string shown(std::string_view text, bool several_lines) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    at += letter.bytes.size();
    if (!letter.valid)
      out += "\xef\xbf\xbd";
    else if (is_control(letter.code) && !(several_lines && letter.code == '\n'))
      out += escaped(letter.code);
    else
      out += letter.bytes;
  }
  return out;
}

}  // namespace

std::string plain_text(std::string_view text) { return shown(text, false); }

std::string plain_lines(std::string_view text) { return shown(text, true); }

}  // namespace eerie::text
