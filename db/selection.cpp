#include "db/selection.hpp"

#include <fmt/format.h>

namespace eerie::db {

std::string conditions(const Selection& s) {
  std::string text;
  if (s.sweep)
    text +=
        " AND id IN (SELECT job_id FROM sweep_jobs JOIN sweeps ON sweeps.id = sweep_id"
        " WHERE sweeps.name = :sweep)";
  for (std::size_t i = 0; i < s.hashes.size(); ++i)
    // Hexadecimal digits end before 'g': a range that the index on hash can walk.
    text += fmt::format("{}(hash >= :hash{} AND hash < :hash{} || 'g')", i == 0 ? " AND (" : " OR ",
                        i, i);
  if (!s.hashes.empty()) text += ")";
  if (s.q) text += " AND q = :q";
  if (s.phi_d_deg) text += " AND phi_d_deg = :phi_d";
  if (s.v_imp_cm_per_s) text += " AND v_imp_cm_per_s BETWEEN :v_lo AND :v_hi";
  if (s.theta_imp_deg) text += " AND theta_imp_deg BETWEEN :theta_lo AND :theta_hi";
  return text;
}

void bind_conditions(SQLite::Statement& statement, const Selection& s) {
  if (s.sweep) statement.bind(":sweep", *s.sweep);
  for (std::size_t i = 0; i < s.hashes.size(); ++i)
    statement.bind(fmt::format(":hash{}", i), s.hashes[i]);
  if (s.q) statement.bind(":q", *s.q);
  if (s.phi_d_deg) statement.bind(":phi_d", *s.phi_d_deg);
  if (s.v_imp_cm_per_s) {
    statement.bind(":v_lo", s.v_imp_cm_per_s->lo);
    statement.bind(":v_hi", s.v_imp_cm_per_s->hi);
  }
  if (s.theta_imp_deg) {
    statement.bind(":theta_lo", s.theta_imp_deg->lo);
    statement.bind(":theta_hi", s.theta_imp_deg->hi);
  }
}

}  // namespace eerie::db
