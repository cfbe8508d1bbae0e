#pragma once

#include <string>
#include <string_view>

#include "campaign/cli/output/answer.hpp"
#include "campaign/cli/output/complain.hpp"
#include "campaign/process/standard_streams.hpp"

namespace eerie::cli {

enum class Format { people, json, csv, nothing };

/// The answer in a format. People's tables take `width` at most (0: what they need); CSV is that
/// of the answer's tables.
std::string rendered(const Answer& answer, Format format, std::size_t width);

/// Standard output: the one place that prints. It keeps in mind what could not be written.
class Output {
 public:
  explicit Output(int descriptor, Format format = Format::people);

  Format format = Format::people;

  void print(const Answer& answer);
  /// Lines for people while a command is at work; nothing in other formats.
  template <class... T>
  void say(Pattern<T...> pattern, const T&... arguments) {
    if (format == Format::people) write(line<T...>(pattern, arguments...));
  }
  /// As it is, but that nothing in it is obeyed by a terminal.
  void write(std::string_view text);

  /// Begins a page anew where that can be.
  void begin_page();
  const process::Terminal& terminal() const { return terminal_; }
  /// Whether nobody takes what is written any more: they have gone, or the disk is full.
  bool is_over() const { return problem_ != 0; }
  /// Throws EnvironmentError where something could not be written. A reader who has closed the
  /// pipe has seen enough: that is no error.
  void finish();

 private:
  int descriptor_;
  process::Terminal terminal_;
  int problem_ = 0;  ///< errno of the first failure
};

}  // namespace eerie::cli
