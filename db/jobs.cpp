#include "db/jobs.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include "db/bind.hpp"
#include "db/error.hpp"

namespace eerie::db {
namespace {

/// The sweep's row, made where missing.
std::int64_t sweep_id(SQLite::Database& sql, const std::string& name, const std::string& document) {
  SQLite::Statement insert(sql, "INSERT OR IGNORE INTO sweeps (name, document) VALUES (?, ?)");
  bind_all(insert, name, document);
  insert.exec();
  SQLite::Statement find(sql, "SELECT id FROM sweeps WHERE name = ? AND document = ?");
  bind_all(find, name, document);
  find.executeStep();
  return find.getColumn(0).getInt64();
}

void set_state(SQLite::Database& sql, std::int64_t job, JobState state) {
  SQLite::Statement update(sql, "UPDATE jobs SET state = ? WHERE id = ?");
  bind_all(update, name(job_state_names, state), job);
  if (update.exec() != 1) throw Error(fmt::format("there is no job {} in the database", job));
}

void close_attempt(SQLite::Database& sql, std::int64_t job, const AttemptEnd& end) {
  SQLite::Statement update(sql, R"(UPDATE attempts SET
      ended = strftime('%Y-%m-%dT%H:%M:%fZ', 'now'), exit_reason = ?, failure_kind = ?,
      message = ?, core_seconds = ?, particle_steps = ?, peak_memory_bytes = ?
      WHERE job_id = ? AND ended IS NULL)");
  bind_all(update, name(exit_reason_names, end.reason), null_if_empty(end.failure_kind),
           null_if_empty(end.message), end.core_seconds, end.particle_steps, end.peak_memory_bytes,
           job);
  update.exec();
}

void insert_result(SQLite::Database& sql, std::int64_t job, const Result& r) {
  SQLite::Statement insert(sql, R"(INSERT OR REPLACE INTO job_results
      (job_id, class, m_lr_over_m_total, m_slr_over_m_total, b_over_a, c_over_a, period_h, eer,
       n_eer, n_remnants, settled, unsettled_reason, dL_over_L, steps, particle_steps, wall_s,
       threads, solver_version, host)
      VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?))");
  bind_all(insert, job, r.outcome_class, r.m_lr_over_m_total, r.m_slr_over_m_total, r.b_over_a,
           r.c_over_a, r.period_h, int{r.eer}, r.n_eer, r.n_remnants, int{r.settled},
           null_if_empty(r.unsettled_reason), r.dL_over_L, r.steps, r.particle_steps, r.wall_s,
           r.threads, r.solver_version, r.host);
  insert.exec();
}

void insert_remnants(SQLite::Database& sql, std::int64_t job, std::span<const Remnant> remnants) {
  SQLite::Statement clear(sql, "DELETE FROM job_remnants WHERE job_id = ?");
  bind_all(clear, job);
  clear.exec();
  SQLite::Statement insert(sql, R"(INSERT INTO job_remnants
      (job_id, rank, particles, mass_kg, mass_over_total, a_m, b_m, c_m, b_over_a, c_over_a,
       spin_period_h, eer, target_fraction, bound_group, bound_mass_over_total,
       x_m, y_m, z_m, vx_m_per_s, vy_m_per_s, vz_m_per_s)
      VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?))");
  for (const Remnant& m : remnants) {
    bind_all(insert, job, m.rank, m.particles, m.mass_kg, m.mass_over_total, m.a_m, m.b_m, m.c_m,
             m.b_over_a, m.c_over_a, m.spin_period_h, int{m.eer}, m.target_fraction, m.bound_group,
             m.bound_mass_over_total, m.x_m, m.y_m, m.z_m, m.vx_m_per_s, m.vy_m_per_s,
             m.vz_m_per_s);
    insert.exec();
  }
}

}  // namespace

AddedSweep add_sweep(Connection& connection, const std::string& name, const std::string& document,
                     std::span<const NewJob> new_jobs) {
  AddedSweep added{0, new_jobs.size(), 0};
  connection.write([&](SQLite::Database& sql) {
    added.sweep = sweep_id(sql, name, document);
    SQLite::Statement insert(sql, R"(INSERT OR IGNORE INTO jobs
        (hash, q, phi_d_deg, v_imp_cm_per_s, theta_imp_deg, v_over_v_esc, particles_per_target,
         seed, end_time_s, expected_particle_steps) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?))");
    SQLite::Statement insert_scene(
        sql, "INSERT INTO job_scenes (job_id, scene) SELECT id, ? FROM jobs WHERE hash = ?");
    SQLite::Statement join(sql,
                           "INSERT OR IGNORE INTO sweep_jobs (sweep_id, job_id) SELECT ?, id FROM "
                           "jobs WHERE hash = ?");
    for (const NewJob& j : new_jobs) {
      bind_all(insert, j.hash, j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
               j.particles_per_target, j.seed, j.end_time_s, j.expected_particle_steps);
      if (insert.exec() == 1) {
        ++added.added;
        bind_all(insert_scene, j.scene, j.hash);
        insert_scene.exec();
      }
      bind_all(join, added.sweep, j.hash);
      join.exec();
    }
  });
  return added;
}

std::size_t count_unknown(const Connection& connection, std::span<const NewJob> new_jobs) {
  std::size_t unknown = 0;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement find(sql, "SELECT 1 FROM jobs WHERE hash = ?");
    for (const NewJob& job : new_jobs) {
      bind_all(find, job.hash);
      if (!find.executeStep()) ++unknown;
    }
  });
  return unknown;
}

std::vector<Job> jobs(const Connection& connection, const JobFilter& filter) {
  std::string text =
      "SELECT id, hash, state, crashes, q, phi_d_deg, v_imp_cm_per_s, theta_imp_deg, "
      "expected_particle_steps FROM jobs WHERE 1";
  if (filter.sweep) text += " AND id IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = :sweep)";
  if (filter.state) text += " AND state = :state";
  text += " ORDER BY priority DESC, expected_particle_steps DESC, id";
  std::vector<Job> rows;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, text);
    if (filter.sweep) select.bind(":sweep", *filter.sweep);
    if (filter.state) select.bind(":state", std::string(name(job_state_names, *filter.state)));
    while (select.executeStep()) {
      Job job;
      job.id = select.getColumn(0).getInt64();
      job.hash = select.getColumn(1).getString();
      job.state = enumerator<JobState>(job_state_names, select.getColumn(2).getString());
      job.crashes = select.getColumn(3).getInt();
      job.q = select.getColumn(4).getDouble();
      job.phi_d_deg = select.getColumn(5).getDouble();
      job.v_imp_cm_per_s = select.getColumn(6).getDouble();
      job.theta_imp_deg = select.getColumn(7).getDouble();
      job.expected_particle_steps = select.getColumn(8).getDouble();
      rows.push_back(std::move(job));
    }
  });
  return rows;
}

std::string scene(const Connection& connection, std::int64_t job) {
  std::string text;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, "SELECT scene FROM job_scenes WHERE job_id = ?");
    bind_all(select, job);
    if (!select.executeStep()) throw Error(fmt::format("there is no job {} in the database", job));
    text = select.getColumn(0).getString();
  });
  return text;
}

std::int64_t begin_attempt(Connection& connection, std::int64_t job, const std::string& host,
                           std::int64_t pid, const std::string& version) {
  std::int64_t attempt = 0;
  connection.write([&](SQLite::Database& sql) {
    set_state(sql, job, JobState::running);
    SQLite::Statement insert(
        sql, "INSERT INTO attempts (job_id, host, pid, version) VALUES (?, ?, ?, ?)");
    bind_all(insert, job, host, pid, version);
    insert.exec();
    attempt = sql.getLastInsertRowid();
  });
  return attempt;
}

void end_attempt(Connection& connection, std::int64_t job, const AttemptEnd& end, JobState next) {
  connection.write([&](SQLite::Database& sql) {
    set_state(sql, job, next);
    close_attempt(sql, job, end);
    if (end.reason == ExitReason::crashed) {
      SQLite::Statement count(sql, "UPDATE jobs SET crashes = crashes + 1 WHERE id = ?");
      bind_all(count, job);
      count.exec();
    }
  });
}

void finish(Connection& connection, std::int64_t job, const AttemptEnd& end, const Result& result,
            std::span<const Remnant> remnants) {
  connection.write([&](SQLite::Database& sql) {
    set_state(sql, job, JobState::done);
    close_attempt(sql, job, end);
    insert_result(sql, job, result);
    insert_remnants(sql, job, remnants);
  });
}

std::size_t retry_failed(Connection& connection, std::int64_t sweep) {
  std::size_t count = 0;
  connection.write([&](SQLite::Database& sql) {
    SQLite::Statement update(sql, R"(UPDATE jobs SET state = 'pending', crashes = 0
        WHERE state = 'failed' AND id IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = ?))");
    bind_all(update, sweep);
    count = static_cast<std::size_t>(update.exec());
  });
  return count;
}

}  // namespace eerie::db
