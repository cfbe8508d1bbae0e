#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "campaign/text/plain_text.hpp"
#include "campaign/text/quantities.hpp"
#include "campaign/text/table.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {

using text::both, text::chosen, text::data, text::or_null, text::records, text::shown;
using text::count_of, text::duration, text::magnitude;
using text::Field, text::Table, text::Value, text::table_of;

inline constexpr int stopped_by_signal = 130;  // 128 + SIGINT, as shells expect

/// An argument of a line for people. Texts and paths, which may come from users or files, are made
/// plain.
template <class T>
decltype(auto) plain_argument(const T& value) {
  if constexpr (std::is_same_v<T, std::filesystem::path>)
    return text::plain_text(value.string());
  else if constexpr (std::is_convertible_v<const T&, std::string_view>)
    return text::plain_text(std::string_view(value));
  else
    return (value);
}

template <class... T>
using Pattern = fmt::format_string<decltype(plain_argument(std::declval<const T&>()))...>;

/// fmt::format() with plain arguments, so that only the pattern can end a line.
template <class... T>
std::string line(Pattern<T...> pattern, const T&... arguments) {
  return fmt::format(pattern, plain_argument(arguments)...);
}

/// The answer of a command: a document for programs, and lines and tables for people. A command
/// does not know how its answer is printed.
class Answer {
 public:
  Answer() = default;
  explicit Answer(int code) : exit_code(code) {}
  explicit Answer(ExitCode code) : exit_code(static_cast<int>(code)) {}

  nlohmann::json data;  ///< the document that --json prints
  int exit_code = 0;

  /// Adds lines for people.
  template <class... T>
  void say(Pattern<T...> pattern, const T&... arguments) {
    add_text(cli::line<T...>(pattern, arguments...));
  }
  /// Adds a table for people and for CSV, with its legend below.
  void add(Table table, const std::string& legend = "") {
    blocks_.emplace_back(std::move(table));
    if (!legend.empty()) add_text("\n" + legend);
  }
  /// Adds lines that line() has made.
  void add_text(std::string text) { blocks_.emplace_back(std::move(text)); }
  /// Adds a line for each file.
  void add_files(const std::vector<std::filesystem::path>& files) {
    for (const auto& file : files) say("{}\n", file);
  }
  /// Adds a complaint, which goes to standard error after everything else.
  template <class... T>
  void complain(Pattern<T...> pattern, const T&... arguments) {
    complaints_.push_back(cli::line<T...>(pattern, arguments...));
  }

  /// Adds a warning, which JSON contains in its document.
  void warn(const std::string& text) { warnings_.push_back(text); }

  using Block = std::variant<std::string, Table>;
  const std::vector<Block>& blocks() const { return blocks_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  std::vector<Block> blocks_;
  std::vector<std::string> warnings_, complaints_;
};

/// The end of a complaint about a database: "`eerie status --db FILE` shows what it holds".
std::string see_status(const std::filesystem::path& database);

/// Paths as a list of texts.
nlohmann::json names_of(const std::vector<std::filesystem::path>& files);

}  // namespace eerie::cli
