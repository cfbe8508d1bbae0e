#pragma once

#include <string>
#include <string_view>

namespace eerie::text {

/// Makes one line of a text from a file, a user or another program, which terminals and logs show
/// and do not obey. Control characters (solver/base/utf8.hpp: is_control) become escapes: "\n",
/// "\t", "\x1b", "\u202e". Bytes that are not UTF-8 become U+FFFD. Everything else stays. Plain
/// text does not change when it is made plain again.
std::string plain_text(std::string_view text);

/// Makes a text plain that may have several lines. Ends of line ("\n") stay.
std::string plain_lines(std::string_view text);

}  // namespace eerie::text
