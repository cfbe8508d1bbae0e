#include "db/jobs/selection.hpp"

#include <fmt/format.h>

#include <cmath>

#include "db/store/bind.hpp"
#include "solver/base/error.hpp"

namespace eerie::db {

std::string conditions(const Selection& s) {
  std::string text;
  if (s.sweep)
    text +=
        " AND id IN (SELECT job_id FROM sweep_jobs JOIN sweep_labels s ON s.id = sweep_id"
        " WHERE s.name = :sweep OR s.name || '@' || s.number = :sweep)";
  if (!s.hashes.empty())
    // Hexadecimal digits end before 'g': ranges that the index on hash can walk, of any number.
    text +=
        " AND id IN (SELECT j.id FROM json_each(:hashes) h CROSS JOIN jobs j"
        " ON j.hash >= h.value AND j.hash < h.value || 'g')";
  return text + point_conditions(s);
}

void require_usable(const Selection& s) {
  constexpr std::size_t longest = 64;
  for (const std::string& hash : s.hashes)
    if (hash.empty() || hash.size() > longest ||
        hash.find_first_not_of("0123456789abcdef") != std::string::npos)
      throw InputError(fmt::format("'{}': a job is named by 1 to {} hexadecimal digits of its hash",
                                   hash, longest));
  const auto require_finite = [](double value, const char* name) {
    if (!std::isfinite(value))
      throw InputError(fmt::format("{} = {}: must be a finite number", name, value));
  };
  const auto require_range = [&](const std::optional<Range>& range, const char* name) {
    if (!range) return;
    require_finite(range->lo, name), require_finite(range->hi, name);
    if (range->lo > range->hi)
      throw InputError(fmt::format("{} = {}:{}: the first is greater than the second; swap them",
                                   name, range->lo, range->hi));
  };
  if (s.q) require_finite(*s.q, "q");
  if (s.phi_d_deg) require_finite(*s.phi_d_deg, "phi_d_deg");
  require_range(s.v_imp_cm_per_s, "v_imp_cm_per_s");
  require_range(s.theta_imp_deg, "theta_imp_deg");
}

void bind_conditions(SQLite::Statement& statement, const Selection& s) {
  if (s.sweep) statement.bind(":sweep", *s.sweep);
  if (!s.hashes.empty())
    statement.bind(":hashes", fmt::format("[\"{}\"]", fmt::join(s.hashes, "\",\"")));
  bind_point(statement, s);
}

}  // namespace eerie::db
