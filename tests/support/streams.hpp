#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/program.hpp"

namespace eerie::test {

/// The program with standard output on a full disk, or on a pipe that nobody reads any more; `out`
/// stays empty.
Ended on_full_disk(const std::filesystem::path& folder, const std::vector<std::string>& arguments);
Ended into_closed_pipe(const std::filesystem::path& folder,
                       const std::vector<std::string>& arguments);
/// The same with standard error on such a pipe; `err` stays empty.
Ended complaining_to_nobody(const std::filesystem::path& folder,
                            const std::vector<std::string>& arguments);

/// The program with both on a terminal of its own; `out` is what both wrote.
struct FakeTerminal {
  unsigned short columns = 80;
  std::string kind = "xterm";  ///< TERM
};
Ended on_terminal(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                  const FakeTerminal& terminal);

}  // namespace eerie::test
