#include "campaign/cli/output/complain.hpp"

#include <unistd.h>

#include "campaign/process/standard_streams.hpp"
#include "campaign/text/plain_text.hpp"

namespace eerie::cli {

void complain(std::string_view text) {
  process::write_all(STDERR_FILENO, text::plain_lines(text) + "\n");
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) complain("warning: " + warning);
}

}  // namespace eerie::cli
