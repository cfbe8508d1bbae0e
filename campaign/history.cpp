#include "campaign/history.hpp"

#include <fmt/format.h>

#include <sstream>

#include "solver/base/file.hpp"

namespace eerie {
namespace fs = std::filesystem;

namespace {

std::string header() {
  std::string names;
  HistoryRow row;
  visit_columns(row, [&](const char* name, const auto&) {
    names += std::string(names.empty() ? "" : ",") + name;
  });
  return names + "\n";
}

std::string line_of(const HistoryRow& row) {
  std::string line;
  visit_columns(row, [&](const char*, const auto& value) {
    line += fmt::format("{}{}", line.empty() ? "" : ",", value);
  });
  return line + "\n";
}

/// Whether the line has a number for every column, and no more.
bool parse_line(const std::string& line, HistoryRow& row) {
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

}  // namespace

std::vector<HistoryRow> read_history(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return {};
  std::istringstream lines(read_file(path));
  std::vector<HistoryRow> rows;
  HistoryRow row;
  for (std::string line; std::getline(lines, line);)
    if (parse_line(line, row)) rows.push_back(row);
  return rows;
}

HistoryRow history_row(double time_s, const Analysis& analysis) {
  HistoryRow row;
  row.time_s = time_s;
  row.n_remnants = static_cast<int>(analysis.remnants.size());
  if (!analysis.remnants.empty()) {
    row.m_1_over_m_total = analysis.remnants[0].mass_over_total;
    row.b_over_a = analysis.remnants[0].shape.b_over_a();
    row.c_over_a = analysis.remnants[0].shape.c_over_a();
  }
  if (analysis.remnants.size() > 1) row.m_2_over_m_total = analysis.remnants[1].mass_over_total;
  return row;
}

History::History(fs::path path) : path_(std::move(path)), rows_(read_history(path_)) {}

void History::add(const HistoryRow& row) {
  std::erase_if(rows_, [&](const HistoryRow& r) { return r.time_s >= row.time_s; });
  rows_.push_back(row);
  std::string text = header();
  for (const HistoryRow& r : rows_) text += line_of(r);
  install_text(path_, text);
}

bool separated_after_contact(const std::vector<HistoryRow>& rows, double q) {
  const double large = 0.5 * q / (1 + q);
  bool touched = false;
  for (const HistoryRow& row : rows) {
    const bool apart = row.m_1_over_m_total >= large && row.m_2_over_m_total >= large;
    if (apart && touched) return true;
    if (!apart) touched = true;
  }
  return false;
}

}  // namespace eerie
