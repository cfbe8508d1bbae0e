#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace eerie {

/// One letter of a UTF-8 text.
struct Letter {
  char32_t code = 0;
  std::string_view bytes;  ///< a part of the text that was read
  bool valid = true;       ///< false for a byte that is not UTF-8, whose code is U+FFFD
};

/// The letter that begins at `at` < text.size(). Overlong forms, surrogates and cut sequences are
/// not UTF-8: each of their bytes counts as one letter that is not valid.
Letter letter_at(std::string_view text, std::size_t at);

/// The text, with U+FFFD in place of each byte that is not UTF-8.
std::string valid_utf8(std::string_view text);

/// Whether a letter shows nothing: C0 and C1 controls, DEL, ends of line and of paragraph, marks
/// that turn the direction of writing, noncharacters.
bool is_control(char32_t code);

}  // namespace eerie
