#pragma once

#include <SQLiteCpp/Statement.h>

#include <optional>
#include <string>
#include <vector>

#include "db/jobs/rows.hpp"

namespace eerie::db {

struct Range {
  double lo, hi;  ///< both inclusive
};

/// Which jobs a request is about; an empty condition holds for every job.
struct Selection {
  std::optional<std::string> sweep = {};  ///< by name
  std::vector<std::string> hashes = {};   ///< whole or their first digits
  std::optional<double> q = {}, phi_d_deg = {};
  std::optional<Range> v_imp_cm_per_s = {}, theta_imp_deg = {};

  bool is_everything() const {
    return !sweep && hashes.empty() && !q && !phi_d_deg && !v_imp_cm_per_s && !theta_imp_deg;
  }
};

/// Throws InputError for hashes that are none, and numbers that are not finite or in no order: an
/// empty hash, say, would mean every job.
void require_usable(const Selection& selection);

/// " AND ..." for a statement over `jobs`, and its parameters.
std::string conditions(const Selection& selection);
void bind_conditions(SQLite::Statement& statement, const Selection& selection);

}  // namespace eerie::db
