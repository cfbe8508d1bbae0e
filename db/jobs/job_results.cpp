#include "db/jobs/job_results.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>

#include "db/store/bind.hpp"

namespace eerie::db {
namespace {

/// An INSERT of one value for each of the columns "a, b, ...".
std::string insertion(const char* verb_and_table, const std::string& columns) {
  std::string values = "?";
  for (auto commas = std::ranges::count(columns, ','); commas > 0; --commas) values += ", ?";
  return fmt::format("{} ({}) VALUES ({})", verb_and_table, columns, values);
}

}  // namespace

void insert_result(SQLite::Database& sql, std::int64_t job, const Result& r) {
  SQLite::Statement insert(
      sql, insertion("INSERT OR REPLACE INTO job_results",
                     "job_id, class, m_lr_over_m_total, m_slr_over_m_total, b_over_a, c_over_a, "
                     "period_h, eer, n_eer, n_remnants, settled, unsettled_reason, dL_over_L, "
                     "steps, particle_steps, wall_s, threads, solver_version, host, ended_at_s, "
                     "end_reason"));
  bind_all(insert, job, r.outcome_class, r.m_lr_over_m_total, r.m_slr_over_m_total, r.b_over_a,
           r.c_over_a, r.period_h, int{r.eer}, r.n_eer, r.n_remnants, int{r.settled},
           null_if_empty(r.unsettled_reason), r.dL_over_L, r.steps, r.particle_steps, r.wall_s,
           r.threads, r.solver_version, r.host, r.ended_at_s, null_if_empty(r.end_reason));
  insert.exec();
}

void insert_remnants(SQLite::Database& sql, std::int64_t job, std::span<const Remnant> remnants) {
  SQLite::Statement clear(sql, "DELETE FROM job_remnants WHERE job_id = ?");
  bind_all(clear, job);
  clear.exec();
  std::string columns =
      "job_id, rank, particles, mass_kg, mass_over_total, a_m, b_m, c_m, b_over_a, c_over_a, "
      "spin_period_h, eer, target_fraction, bound_group, bound_mass_over_total, x_m, y_m, z_m, "
      "vx_m_per_s, vy_m_per_s, vz_m_per_s, shape_class";
  for (const char* column : remnant_detail_columns) columns += fmt::format(", {}", column);
  SQLite::Statement insert(sql, insertion("INSERT INTO job_remnants", columns));
  constexpr int fixed = 22;
  for (const Remnant& m : remnants) {
    bind_all(insert, job, m.rank, m.particles, m.mass_kg, m.mass_over_total, m.a_m, m.b_m, m.c_m,
             m.b_over_a, m.c_over_a, m.spin_period_h, int{m.eer}, m.target_fraction, m.bound_group,
             m.bound_mass_over_total, m.x_m, m.y_m, m.z_m, m.vx_m_per_s, m.vy_m_per_s, m.vz_m_per_s,
             null_if_empty(m.shape_class));
    for (std::size_t k = 0; k < m.details.size(); ++k)
      bind_value(insert, fixed + 1 + static_cast<int>(k), m.details[k]);
    insert.exec();
  }
}

void replace_analysis(Connection& connection, std::int64_t job, const Result& r,
                      std::span<const Remnant> remnants) {
  connection.write([&](SQLite::Database& sql) {
    SQLite::Statement update(sql, R"(UPDATE job_results SET
        class = ?, m_lr_over_m_total = ?, m_slr_over_m_total = ?, b_over_a = ?, c_over_a = ?,
        period_h = ?, eer = ?, n_eer = ?, n_remnants = ?, settled = ?, unsettled_reason = ?
        WHERE job_id = ?)");
    bind_all(update, r.outcome_class, r.m_lr_over_m_total, r.m_slr_over_m_total, r.b_over_a,
             r.c_over_a, r.period_h, int{r.eer}, r.n_eer, r.n_remnants, int{r.settled},
             null_if_empty(r.unsettled_reason), job);
    update.exec();
    insert_remnants(sql, job, remnants);
  });
}

}  // namespace eerie::db
