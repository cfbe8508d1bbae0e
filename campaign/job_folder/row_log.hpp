#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "solver/base/file.hpp"

namespace eerie::job_folder {

/// Rows over time in a CSV file that a cut-off run goes on with. A Row has `time_s`, and
/// visit_columns(row, visit) names its numbers in the order of the columns.
template <class Row>
class RowLog {
 public:
  /// Goes on from the rows of an earlier attempt, where the file has some. Lines that are cut off
  /// are left out.
  explicit RowLog(std::filesystem::path path) : path_(std::move(path)) {
    std::error_code ignored;
    if (!std::filesystem::exists(path_, ignored)) return;
    std::istringstream lines(read_file(path_));
    Row row;
    for (std::string line; std::getline(lines, line);)
      if (parse(line, row)) rows_.push_back(row);
  }

  /// Installs the file with these rows of one moment; rows of the same or a later time, left by an
  /// attempt that was cut off after its last checkpoint, give way.
  void add(const std::vector<Row>& rows) {
    if (rows.empty()) return;
    std::erase_if(rows_, [&](const Row& r) { return r.time_s >= rows.front().time_s; });
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    std::string text = header();
    for (const Row& r : rows_) text += line_of(r);
    install_text(path_, text);
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

  static std::string line_of(const Row& row) {
    std::string line;
    visit_columns(row, [&](const char*, const auto& value) {
      line += fmt::format("{}{}", line.empty() ? "" : ",", value);
    });
    return line + "\n";
  }

  /// Whether the line has a number for every column, and no more.
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
};

}  // namespace eerie::job_folder
