#pragma once

#include <filesystem>
#include <vector>

#include "analysis/analysis.hpp"

namespace eerie {

/// One row of history.csv: the largest remnants at one moment of the run.
struct HistoryRow {
  double time_s = 0;
  int n_remnants = 0;
  double m_1_over_m_total = 0, m_2_over_m_total = 0;  ///< the two largest remnants
  double b_over_a = 0, c_over_a = 0;                  ///< of the largest
};

/// The shape of an impact over time, in a file that a cut-off run goes on with.
class History {
 public:
  /// Goes on from the rows of an earlier attempt, where the file has some.
  explicit History(std::filesystem::path path);

  /// Installs the file with this row; rows of the same or a later time, left by an attempt that
  /// was cut off after its last checkpoint, give way.
  void add(double time_s, const Analysis& analysis);

  const std::vector<HistoryRow>& rows() const { return rows_; }

 private:
  std::filesystem::path path_;
  std::vector<HistoryRow> rows_;
};

/// Whether two large bodies (each at least half the impactor's share of the mass) were seen
/// apart after they had been one: a merger of this kind is graze-and-merge.
bool separated_after_contact(const std::vector<HistoryRow>& rows, double q);

}  // namespace eerie
