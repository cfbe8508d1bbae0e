#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "solver/base/file.hpp"

namespace eerie::job_folder {

/// Rows over time in a CSV file, which an interrupted run continues. A Row has `time_s`, and
/// visit_columns(row, visit) visits its numbers with their names, in the order of the columns.
template <class Row>
class RowLog {
 public:
  /// Continues the rows of an earlier attempt, where the file has some. It leaves out incomplete
  /// lines.
  explicit RowLog(std::filesystem::path path) : path_(std::move(path)) {
    std::error_code ignored;
    if (!std::filesystem::exists(path_, ignored)) return;
    std::istringstream lines(read_file(path_));
    Row row;
    for (std::string line; std::getline(lines, line) && !lines.eof();)
      if (parse(line, row)) rows_.push_back(row);
  }

  /// Adds these rows of one moment to the file. They replace rows of the same or a later time,
  /// which an attempt has left that was interrupted after its last checkpoint. A power cut may take
  /// them again until flush() has returned.
  void add(const std::vector<Row>& rows) {
    if (rows.empty()) return;
    const auto replaced =
        std::erase_if(rows_, [&](const Row& r) { return r.time_s >= rows.front().time_s; });
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    if (std::exchange(is_ours_, false) && replaced == 0)
      append_text(path_, text_of(rows));
    else
      install_text(path_, header() + text_of(rows_));
    is_ours_ = true;
  }

  /// Flushes what was added to the disk.
  void flush() const {
    if (is_ours_) flush_file(path_);
  }

  const std::vector<Row>& rows() const { return rows_; }

 private:
  static std::string header() {
    std::string names;
    Row row;
    visit_columns(row, [&](const char* name, const auto&) {
      names += std::string(names.empty() ? "" : ",") + name;
    });
    return names + "\n";
  }

  static std::string text_of(const std::vector<Row>& rows) {
    std::string text;
    for (const Row& row : rows) text += line_of(row);
    return text;
  }

  static std::string line_of(const Row& row) {
    std::string line;
    visit_columns(row, [&](const char*, const auto& value) {
      line += fmt::format("{}{}", line.empty() ? "" : ",", value);
    });
    return line + "\n";
  }

  /// Whether the line has exactly one number for every column.
  static bool parse(const std::string& line, Row& row) {
    std::istringstream in(line);
    bool first = true, whole = true;
    visit_columns(row, [&](const char*, auto& value) {
      char comma = ',';
      if (!first) in >> comma;
      first = false;
      whole = whole && comma == ',' && static_cast<bool>(in >> value);
    });
    return whole && in.peek() == std::char_traits<char>::eof();
  }

  std::filesystem::path path_;
  std::vector<Row> rows_;
  bool is_ours_ = false;  ///< whether the file holds these rows and nothing else
};

}  // namespace eerie::job_folder
