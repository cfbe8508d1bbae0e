#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "campaign/process/standard_streams.hpp"

namespace eerie::cli {

/// What is going on, on standard error: one line that redraws itself twice a second on a terminal
/// and always fits it, else a line at most every ten seconds.
class StatusLine {
 public:
  StatusLine();
  /// `text` gives a line of at most so many columns (0: any), with more in it for people who look
  /// on.
  using Text = std::function<std::string(std::size_t width, bool on_terminal)>;
  void show(const Text& text);
  void finish();  ///< leaves the terminal's line

 private:
  void draw(const std::string& text);

  process::Terminal terminal_;
  std::size_t drawn_ = 0;  ///< columns of what stands there
  std::chrono::steady_clock::time_point next_;
};

/// Shows "examined 3 of 15" on a terminal; leaves its line at the last.
class CountLine {
 public:
  explicit CountLine(std::string verb) : verb_(std::move(verb)) {}
  void show(std::size_t done, std::size_t all);

 private:
  std::string verb_;
  StatusLine line_;
};

}  // namespace eerie::cli
