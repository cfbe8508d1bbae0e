#pragma once

#include <SQLiteCpp/Statement.h>

#include <optional>
#include <string>
#include <vector>

#include "db/jobs/rows.hpp"

namespace eerie::db {

struct Range {
  double lo, hi;  ///< both ends are included
};

/// The jobs that a request concerns. An empty condition holds for every job.
struct Selection {
  std::optional<std::string> sweep = {};  ///< the name of the sweep
  std::vector<std::string> hashes = {};   ///< whole hashes or their first digits
  std::optional<double> q = {}, phi_d_deg = {};
  std::optional<Range> v_imp_cm_per_s = {}, theta_imp_deg = {};

  bool is_everything() const {
    return !sweep && hashes.empty() && !q && !phi_d_deg && !v_imp_cm_per_s && !theta_imp_deg;
  }
};

/// Throws InputError for words that are no hashes, and for ranges that are not finite or not in
/// order. An empty hash, for example, would select every job.
void require_usable(const Selection& selection);

/// The conditions " AND ..." for a statement over `jobs`, with their parameters.
std::string conditions(const Selection& selection);
void bind_conditions(SQLite::Statement& statement, const Selection& selection);

}  // namespace eerie::db
