#include "campaign/cli/output/output.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "campaign/text/json_text.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::cli {

std::string see_status(const std::filesystem::path& database) {
  return fmt::format("`eerie status --db {}` shows what it holds", shell_word(database.string()));
}

nlohmann::json names_of(const std::vector<std::filesystem::path>& files) {
  nlohmann::json names = nlohmann::json::array();
  for (const auto& file : files) names.push_back(file.string());
  return names;
}

std::string rendered(const Answer& answer, Format format, std::size_t width) {
  // A path may be no UTF-8, which JSON must be.
  if (format == Format::json) return text::json_text(answer.data, 1) + "\n";
  std::string out;
  for (const Answer::Block& block : answer.blocks()) {
    const auto* table = std::get_if<Table>(&block);
    if (format == Format::people)
      out += table != nullptr ? text::aligned(*table, width) : std::get<std::string>(block);
    else if (format == Format::csv && table != nullptr && text::is_for_programs(*table))
      out += text::csv(*table);
  }
  return out;
}

Output::Output(int descriptor, Format format_)
    : format(format_), descriptor_(descriptor), terminal_(process::terminal_at(descriptor)) {}

void Output::print(const Answer& answer) {
  if (format != Format::nothing) write(rendered(answer, format, terminal_.width));
  if (format != Format::json) print_warnings(answer.warnings());
  for (const std::string& complaint : answer.complaints()) complain(complaint);
}

void Output::write(std::string_view text) {
  if (problem_ != 0) return;
  problem_ = process::write_all(descriptor_,
                                terminal_.is_one ? text::plain_lines(text) : std::string(text));
}

void Output::begin_page() {
  const bool obeys = terminal_.is_one && !terminal_.is_dumb;
  if (problem_ == 0) problem_ = process::write_all(descriptor_, obeys ? "\033[H\033[J" : "\n");
}

void Output::finish() {
  // What others have printed, and what a network's disk tells only now.
  if (problem_ == 0 && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)) problem_ = errno;
  const int copy = ::dup(descriptor_);
  if (copy >= 0 && ::close(copy) != 0 && problem_ == 0) problem_ = errno;
  if (problem_ != 0 && problem_ != EPIPE)
    throw EnvironmentError(fmt::format("cannot write the output: {}", std::strerror(problem_)));
}

}  // namespace eerie::cli
