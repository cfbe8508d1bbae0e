#pragma once

#include <string>
#include <string_view>

#include "campaign/cli/output/answer.hpp"
#include "campaign/cli/output/complain.hpp"
#include "campaign/process/standard_streams.hpp"

namespace eerie::cli {

enum class Format { people, json, csv, nothing };

/// The answer in a format. Tables for people are at most `width` columns wide (0: no limit). CSV
/// consists of the tables of the answer.
std::string rendered(const Answer& answer, Format format, std::size_t width);

/// Standard output, the one place that prints. It remembers the first failure to write.
class Output {
 public:
  explicit Output(int descriptor, Format format = Format::people);

  Format format = Format::people;

  void print(const Answer& answer);
  /// Prints lines for people while a command works; nothing in other formats.
  template <class... T>
  void say(Pattern<T...> pattern, const T&... arguments) {
    if (format == Format::people) write(line<T...>(pattern, arguments...));
  }
  /// Writes a text. On a terminal it makes the text plain, so that the terminal obeys nothing in
  /// it.
  void write(std::string_view text);

  /// Clears the terminal for a new page where it can.
  void begin_page();
  const process::Terminal& terminal() const { return terminal_; }
  /// Whether writing has failed, because the reader has gone or the disk is full.
  bool is_over() const { return problem_ != 0; }
  /// Throws EnvironmentError where writing failed. A pipe that its reader has closed is no error.
  void finish();

 private:
  int descriptor_;
  process::Terminal terminal_;
  int problem_ = 0;  ///< errno of the first failure
};

}  // namespace eerie::cli
