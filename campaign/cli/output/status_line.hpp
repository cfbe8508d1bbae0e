#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "campaign/process/standard_streams.hpp"

namespace eerie::cli {

/// A line about the present state, on standard error. On a terminal it is redrawn twice a second
/// and always fits; elsewhere a line is written at most every ten seconds.
class StatusLine {
 public:
  StatusLine();
  /// `text` returns a line of at most `width` columns (0: no limit). It may say more where people
  /// look on.
  using Text = std::function<std::string(std::size_t width, bool on_terminal)>;
  void show(const Text& text);
  void finish();  ///< clears the line of the terminal

 private:
  void draw(const std::string& text);

  process::Terminal terminal_;
  std::size_t drawn_ = 0;  ///< columns of the line on the terminal
  std::chrono::steady_clock::time_point next_;
};

/// Shows "examined 3 of 15" on a terminal, and clears the line at the end.
class CountLine {
 public:
  explicit CountLine(std::string verb) : verb_(std::move(verb)) {}
  void show(std::size_t done, std::size_t all);

 private:
  std::string verb_;
  StatusLine line_;
};

}  // namespace eerie::cli
