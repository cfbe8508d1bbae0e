#pragma once

#include <string>
#include <string_view>

namespace eerie::text {

/// A text from a file, a user or another program as one line that terminals and logs show and do
/// not obey. Control characters (solver/base/utf8.hpp: is_control) become escapes: "\n", "\t",
/// "\x1b", "\u202e". Bytes that are no UTF-8 become U+FFFD. All else stays, and plain text made
/// plain again is the same.
std::string plain_text(std::string_view text);

/// The same where the text may have several lines: ends of line ("\n") stay.
std::string plain_lines(std::string_view text);

}  // namespace eerie::text
