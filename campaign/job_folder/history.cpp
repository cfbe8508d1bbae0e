#include "campaign/job_folder/history.hpp"

namespace eerie::job_folder {
namespace fs = std::filesystem;

std::vector<HistoryRow> read_history(const fs::path& path) { return History(path).rows(); }

HistoryRow history_row(double time_s, const std::vector<remnants::Remnant>& found) {
  HistoryRow row;
  row.time_s = time_s;
  row.n_remnants = static_cast<int>(found.size());
  if (!found.empty()) {
    row.m_1_over_m_total = found[0].mass_over_total;
    row.b_over_a = found[0].shape.b_over_a();
    row.c_over_a = found[0].shape.c_over_a();
  }
  if (found.size() > 1) row.m_2_over_m_total = found[1].mass_over_total;
  return row;
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

}  // namespace eerie::job_folder
