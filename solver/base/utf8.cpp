#include "solver/base/utf8.hpp"

namespace eerie {

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";  // U+FFFD

/// How many bytes a letter with this first byte takes; 0 where none begins so.
std::size_t length_of(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xc2) return 0;  // goes on, or would be overlong
  if (first < 0xe0) return 2;
  if (first < 0xf0) return 3;
  return first < 0xf5 ? 4 : 0;
}

bool allowed(char32_t code, std::size_t length) {
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  return !surrogate && !overlong && code < 0x110000;
}

}  // namespace

Letter letter_at(std::string_view text, std::size_t at) {
  const Letter none{0xfffd, text.substr(at, 1), false};
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = length_of(first);
  if (length == 0 || length > text.size() - at) return none;
  char32_t code = length == 1 ? first : first & (0x7fu >> length);
  for (std::size_t k = 1; k < length; ++k) {
    const auto next = static_cast<unsigned char>(text[at + k]);
    if ((next & 0xc0) != 0x80) return none;
    code = code << 6 | (next & 0x3f);
  }
  return allowed(code, length) ? Letter{code, text.substr(at, length), true} : none;
}

std::string valid_utf8(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    out += letter.valid ? letter.bytes : replacement;
    at += letter.bytes.size();
  }
  return out;
}

bool is_control(char32_t c) {
  const bool code = c < 0x20 || (c >= 0x7f && c < 0xa0);
  const bool line = c == 0x2028 || c == 0x2029;
  const bool direction = c == 0x061c || c == 0x200e || c == 0x200f ||
                         (c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
  const bool nothing = (c & 0xfffe) == 0xfffe || (c >= 0xfdd0 && c <= 0xfdef) || c == 0xfeff;
  return code || line || direction || nothing;
}

}  // namespace eerie
