#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "campaign/cli/output/output.hpp"

namespace eerie::cli {

/// A line about the present state, on standard error. On a terminal it is redrawn twice a second
/// and always fits; elsewhere a line is written at most every ten seconds. Whoever wants no answer
/// wants no progress either.
class StatusLine {
 public:
  explicit StatusLine(Format format);
  /// `text` returns a line of at most `width` columns (0: no limit). It may say more where people
  /// look on.
  using Text = std::function<std::string(std::size_t width, bool on_terminal)>;
  void show(const Text& text);
  void finish();  ///< clears the line of the terminal

 private:
  void draw(const std::string& text);

  bool wanted_;
  process::Terminal terminal_;
  std::size_t drawn_ = 0;  ///< columns of the line on the terminal
  std::chrono::steady_clock::time_point next_;
};

/// How long work takes that goes on as it went since the first question.
class Eta {
 public:
  /// " | ETA 20 s" where so large a part of the work (0 to 1) is done; empty where nothing can be
  /// said.
  std::string text(double part);

 private:
  using Clock = std::chrono::steady_clock;
  struct Begun {
    Clock::time_point at;
    double part;
  };
  std::optional<Begun> begun_;
};

/// Shows "examined 3 of 15 | ETA 20 s" on a terminal, and clears the line at the end.
class CountLine {
 public:
  CountLine(std::string verb, Format format) : verb_(std::move(verb)), line_(format) {}
  ~CountLine() { line_.finish(); }
  CountLine(const CountLine&) = delete;
  CountLine& operator=(const CountLine&) = delete;
  void show(std::size_t done, std::size_t all);

 private:
  std::string verb_;
  Eta eta_;
  StatusLine line_;
};

}  // namespace eerie::cli
