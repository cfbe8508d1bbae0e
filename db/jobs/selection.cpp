#include "db/jobs/selection.hpp"

#include <fmt/format.h>

#include "db/store/bind.hpp"

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
  return text + point_conditions(s);
}

void bind_conditions(SQLite::Statement& statement, const Selection& s) {
  if (s.sweep) statement.bind(":sweep", *s.sweep);
  for (std::size_t i = 0; i < s.hashes.size(); ++i)
    statement.bind(fmt::format(":hash{}", i), s.hashes[i]);
  bind_point(statement, s);
}

}  // namespace eerie::db
