#pragma once

#include <cstddef>
#include <string_view>

namespace eerie::process {

/// What is behind a file descriptor that people may read.
struct Terminal {
  bool is_one = false;
  bool is_dumb = true;    ///< obeys no escape sequences
  std::size_t width = 0;  ///< columns; 0: as many as a line needs
};

/// COLUMNS goes before what the terminal says of its width. TERM=dumb, or none, is a dumb one.
Terminal terminal_at(int descriptor);

/// Writes all of it. Returns 0, or the errno of what went wrong.
int write_all(int descriptor, std::string_view text);

/// Opens what of standard input, output and error is closed, so that no file gets their numbers
/// and what is printed is not written into it; writing to a closed pipe is an error, not an end.
void guard_standard_streams();

}  // namespace eerie::process
