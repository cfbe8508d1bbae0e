#include "campaign/history.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <sstream>

#include "solver/base/file.hpp"

namespace eerie {
namespace fs = std::filesystem;

namespace {

constexpr const char* header =
    "time_s,n_remnants,m_1_over_m_total,m_2_over_m_total,b_over_a,c_over_a\n";

std::vector<HistoryRow> read_rows(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return {};
  std::istringstream lines(read_file(path));
  std::vector<HistoryRow> rows;
  for (std::string line; std::getline(lines, line);) {
    HistoryRow r;
    if (std::sscanf(line.c_str(), "%lf,%d,%lf,%lf,%lf,%lf", &r.time_s, &r.n_remnants,
                    &r.m_1_over_m_total, &r.m_2_over_m_total, &r.b_over_a, &r.c_over_a) == 6)
      rows.push_back(r);
  }
  return rows;
}

}  // namespace

History::History(fs::path path) : path_(std::move(path)), rows_(read_rows(path_)) {}

void History::add(double time_s, const Analysis& analysis) {
  std::erase_if(rows_, [&](const HistoryRow& row) { return row.time_s >= time_s; });
  HistoryRow row{time_s, static_cast<int>(analysis.remnants.size()), 0, 0, 0, 0};
  if (!analysis.remnants.empty()) {
    row.m_1_over_m_total = analysis.remnants[0].mass_over_total;
    row.b_over_a = analysis.remnants[0].shape.b_over_a();
    row.c_over_a = analysis.remnants[0].shape.c_over_a();
  }
  if (analysis.remnants.size() > 1) row.m_2_over_m_total = analysis.remnants[1].mass_over_total;
  rows_.push_back(row);
  std::string text = header;
  for (const HistoryRow& r : rows_)
    text += fmt::format("{},{},{},{},{},{}\n", r.time_s, r.n_remnants, r.m_1_over_m_total,
                        r.m_2_over_m_total, r.b_over_a, r.c_over_a);
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
