#include "db/views/query.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "db/store/bind.hpp"

namespace eerie::db {
namespace {

std::optional<double> number(const SQLite::Column& column) {
  return column.isNull() ? std::nullopt : std::optional(column.getDouble());
}

std::string conditions(const ResultFilter& f) {
  std::string text;
  if (f.sweep) text += " AND job IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = :sweep)";
  text += point_conditions(f);
  if (f.outcome_class) text += " AND class = :class";
  if (f.eer_only) text += " AND n_eer > 0";
  if (f.fidelity) text += " AND fidelity = :fidelity";
  if (f.settings) text += " AND settings = :settings";
  return text;
}

void bind_conditions(SQLite::Statement& select, const ResultFilter& f) {
  if (f.sweep) select.bind(":sweep", *f.sweep);
  bind_point(select, f);
  if (f.outcome_class) select.bind(":class", *f.outcome_class);
  if (f.fidelity) select.bind(":fidelity", *f.fidelity);
  if (f.settings) select.bind(":settings", *f.settings);
}

ResultRow result_row(const SQLite::Statement& row) {
  const auto column = [&](const char* name) { return row.getColumn(name); };
  ResultRow r;
  r.job = column("job").getInt64();
  r.hash = column("hash").getString();
  r.q = column("q").getDouble();
  r.phi_d_deg = column("phi_d_deg").getDouble();
  r.v_imp_cm_per_s = column("v_imp_cm_per_s").getDouble();
  r.theta_imp_deg = column("theta_imp_deg").getDouble();
  r.v_over_v_esc = column("v_over_v_esc").getDouble();
  r.particles_per_target = column("particles_per_target").getInt64();
  r.seed = column("seed").getInt64();
  r.end_time_s = column("end_time_s").getDouble();
  r.finished = column("finished").getString();
  r.stale = column("stale").getInt() != 0;
  r.stale_reason = column("stale_reason").getString();
  Result& x = r.result;
  x.outcome_class = column("class").getString();
  x.m_lr_over_m_total = column("m_lr_over_m_total").getDouble();
  x.m_slr_over_m_total = column("m_slr_over_m_total").getDouble();
  x.b_over_a = number(column("b_over_a"));
  x.c_over_a = number(column("c_over_a"));
  x.period_h = number(column("period_h"));
  x.eer = column("eer").getInt() != 0;
  x.n_eer = column("n_eer").getInt();
  x.n_remnants = column("n_remnants").getInt();
  x.settled = column("settled").getInt() != 0;
  x.unsettled_reason = column("unsettled_reason").getString();
  x.dL_over_L = number(column("dL_over_L"));
  x.steps = column("steps").getInt64();
  x.particle_steps = column("particle_steps").getDouble();
  x.wall_s = column("wall_s").getDouble();
  x.threads = column("threads").getInt();
  x.solver_version = column("solver_version").getString();
  x.host = column("host").getString();
  x.ended_at_s = number(column("ended_at_s"));
  x.end_reason = column("end_reason").getString();
  r.fidelity = column("fidelity").getString();
  r.settings = column("settings").getInt64();
  r.scheme = column("scheme").getString();
  return r;
}

Remnant remnant_row(SQLite::Statement& select) {
  const auto column = [&](const char* name) { return select.getColumn(name); };
  Remnant m;
  m.rank = column("rank").getInt();
  m.particles = column("particles").getInt64();
  m.mass_kg = column("mass_kg").getDouble();
  m.mass_over_total = column("mass_over_total").getDouble();
  m.a_m = number(column("a_m"));
  m.b_m = number(column("b_m"));
  m.c_m = number(column("c_m"));
  m.b_over_a = number(column("b_over_a"));
  m.c_over_a = number(column("c_over_a"));
  m.spin_period_h = number(column("spin_period_h"));
  m.eer = column("eer").getInt() != 0;
  m.target_fraction = number(column("target_fraction"));
  if (const SQLite::Column group = column("bound_group"); !group.isNull())
    m.bound_group = group.getInt64();
  m.bound_mass_over_total = number(column("bound_mass_over_total"));
  m.x_m = number(column("x_m"));
  m.y_m = number(column("y_m"));
  m.z_m = number(column("z_m"));
  m.vx_m_per_s = number(column("vx_m_per_s"));
  m.vy_m_per_s = number(column("vy_m_per_s"));
  m.vz_m_per_s = number(column("vz_m_per_s"));
  m.shape_class = column("shape_class").getString();
  for (std::size_t k = 0; k < remnant_detail_columns.size(); ++k)
    m.details[k] = number(column(remnant_detail_columns[k]));
  return m;
}

}  // namespace

std::vector<ResultRow> results(const Connection& connection, const ResultFilter& filter) {
  std::vector<ResultRow> rows;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(
        sql, "SELECT * FROM results WHERE 1" + conditions(filter) +
                 " ORDER BY q, phi_d_deg, v_imp_cm_per_s, theta_imp_deg, seed, job");
    bind_conditions(select, filter);
    while (select.executeStep()) rows.push_back(result_row(select));
  });
  return rows;
}

std::vector<ResultRow> selected_results(const Connection& connection, ViewQuery query) {
  query.view = View::results;
  query.columns.clear();
  std::vector<ResultRow> rows;
  each_row(connection, query, [&](SQLite::Statement& row) { rows.push_back(result_row(row)); });
  return rows;
}

std::vector<Remnant> remnants(const Connection& connection, std::int64_t job) {
  std::vector<Remnant> rows;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, "SELECT * FROM job_remnants WHERE job_id = ? ORDER BY rank");
    select.bind(1, job);
    while (select.executeStep()) rows.push_back(remnant_row(select));
  });
  return rows;
}

std::optional<double> core_seconds(const Connection& connection, std::int64_t job) {
  std::optional<double> sum;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, R"(
        SELECT sum(core_seconds) FROM attempts WHERE job_id = ?
        HAVING count(*) = count(core_seconds))");
    select.bind(1, job);
    if (select.executeStep()) sum = number(select.getColumn(0));
  });
  return sum;
}

std::vector<SweepStatus> sweep_status(const Connection& connection) {
  std::vector<SweepStatus> rows;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, R"(
        WITH counts AS MATERIALIZED (
          SELECT sj.sweep_id, j.state, count(*) AS jobs,
                 sum(CASE WHEN j.state IN ('pending', 'running') THEN j.expected_particle_steps ELSE 0 END) AS steps_left,
                 sum(j.state = 'pending' AND j.wanted <> 'run') AS paused
          FROM sweep_jobs sj JOIN jobs j ON j.id = sj.job_id GROUP BY sj.sweep_id, j.state)
        SELECT s.id, s.name, s.created, c.state, c.jobs, c.steps_left, c.paused, l.label
        FROM counts c JOIN sweeps s ON s.id = c.sweep_id JOIN sweep_labels l ON l.id = s.id ORDER BY s.id)");
    while (select.executeStep()) {
      const std::int64_t id = select.getColumn(0).getInt64();
      if (rows.empty() || rows.back().id != id) {
        rows.emplace_back();
        rows.back().id = id;
        rows.back().name = select.getColumn(1).getString();
        rows.back().created = select.getColumn(2).getString();
        rows.back().label = select.getColumn(7).getString();
      }
      rows.back().jobs[enumerator<JobState>(job_state_names, select.getColumn(3).getString())] =
          select.getColumn(4).getInt64();
      rows.back().particle_steps_left += select.getColumn(5).getDouble();
      rows.back().paused += select.getColumn(6).getInt64();
    }
    SQLite::Statement stale(sql, R"(
        SELECT sj.sweep_id, count(*) FROM job_results r CROSS JOIN sweep_jobs sj ON sj.job_id = r.job_id
        WHERE r.solver_version <> (SELECT value FROM settings WHERE key = 'solver_version')
        GROUP BY sj.sweep_id)");
    while (stale.executeStep())
      for (SweepStatus& row : rows)
        if (row.id == stale.getColumn(0).getInt64()) row.stale = stale.getColumn(1).getInt64();
  });
  return rows;
}

std::vector<AttemptRow> attempts(const Connection& connection, std::int64_t job) {
  std::vector<AttemptRow> rows;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, "SELECT * FROM attempts WHERE job_id = ? ORDER BY id");
    bind_all(select, job);
    const auto text = [&](const char* column) { return select.getColumn(column).getString(); };
    while (select.executeStep()) {
      AttemptRow row{text("host"),  text("worker"),      text("version"),      text("started"),
                     text("ended"), text("exit_reason"), text("failure_kind"), text("message")};
      row.core_seconds = number(select.getColumn("core_seconds"));
      row.particle_steps = number(select.getColumn("particle_steps"));
      if (const SQLite::Column peak = select.getColumn("peak_memory_bytes"); !peak.isNull())
        row.peak_memory_bytes = peak.getInt64();
      rows.push_back(std::move(row));
    }
  });
  return rows;
}

std::vector<std::string> sweeps_of(const Connection& connection, std::int64_t job) {
  std::vector<std::string> names;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(
        sql,
        "SELECT label FROM sweep_labels JOIN sweep_jobs ON sweep_id = id WHERE "
        "job_id = ? ORDER BY id");
    bind_all(select, job);
    while (select.executeStep()) names.push_back(select.getColumn(0).getString());
  });
  return names;
}

std::vector<FailureGroup> failures(const Connection& connection,
                                   std::optional<std::int64_t> sweep) {
  // The last attempt of a failed job holds its cause. Bare columns beside max() come from the
  // row that has the maximum (SQLite documents this).
  std::string text = R"(
      WITH last AS (
        SELECT j.hash AS hash, a.failure_kind AS kind, a.message AS message, max(a.id)
        FROM jobs j JOIN attempts a ON a.job_id = j.id
        WHERE j.state = 'failed')";
  if (sweep) text += " AND j.id IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = :sweep)";
  text += R"( GROUP BY j.id)
      SELECT coalesce(kind, 'unknown'), count(*), min(hash), message FROM last
      GROUP BY 1 ORDER BY 2 DESC)";
  std::vector<FailureGroup> rows;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, text);
    if (sweep) select.bind(":sweep", *sweep);
    while (select.executeStep())
      rows.push_back({select.getColumn(0).getString(), select.getColumn(1).getInt64(),
                      select.getColumn(2).getString(), select.getColumn(3).getString()});
  });
  return rows;
}

Speed speed(const Connection& connection) {
  Speed measured;
  connection.read([&](SQLite::Database& sql) {
    // An attempt's particle-steps are the job's so far; only a job done in one attempt tells
    // how many of them its core-seconds bought.
    SQLite::Statement select(sql, R"(
        SELECT coalesce(sum(core_seconds), 0), coalesce(sum(particle_steps), 0) FROM attempts
        WHERE exit_reason = 'finished' AND core_seconds IS NOT NULL
          AND job_id IN (SELECT job_id FROM attempts GROUP BY job_id HAVING count(*) = 1))");
    select.executeStep();
    measured.core_seconds = select.getColumn(0).getDouble();
    measured.particle_steps = select.getColumn(1).getDouble();
    SQLite::Statement ratio(sql, R"(
        SELECT coalesce(sum(j.expected_particle_steps) / sum(r.particle_steps), 0)
        FROM job_results r JOIN jobs j ON j.id = r.job_id)");
    ratio.executeStep();
    measured.expected_over_done = ratio.getColumn(0).getDouble();
  });
  return measured;
}

double newest_result(const Connection& connection, std::int64_t sweep) {
  double seconds = 0;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, R"(
        SELECT coalesce((julianday(max(r.finished)) - 2440587.5) * 86400.0, 0) FROM job_results r
        JOIN sweep_jobs sj ON sj.job_id = r.job_id WHERE sj.sweep_id = ?)");
    bind_all(select, sweep);
    select.executeStep();
    seconds = select.getColumn(0).getDouble();
  });
  return seconds;
}

}  // namespace eerie::db
