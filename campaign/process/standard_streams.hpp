#pragma once

#include <cstddef>
#include <string_view>

namespace eerie::process {

/// The terminal, if any, behind a file descriptor.
struct Terminal {
  bool is_one = false;
  bool is_dumb = true;    ///< ignores escape sequences
  std::size_t width = 0;  ///< columns; 0: no limit
};

/// The terminal at a descriptor. The variable COLUMNS has precedence over the terminal's own width.
/// With TERM=dumb, or without TERM, the terminal is dumb.
Terminal terminal_at(int descriptor);

/// Writes the whole text. Returns 0, or the errno of the failure.
int write_all(int descriptor, std::string_view text);

/// Opens standard input, output and error where they are closed, so that no other file gets their
/// numbers and receives what is printed. From then on a write to a closed pipe is an error and does
/// not end the process.
void guard_standard_streams();

}  // namespace eerie::process
