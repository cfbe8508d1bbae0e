#include "db/jobs/jobs.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <numeric>

#include "db/jobs/job_results.hpp"
#include "db/store/bind.hpp"
#include "db/store/error.hpp"

namespace eerie::db {
using namespace std::string_literals;

namespace {

constexpr const char* select_jobs =
    "SELECT id, hash, state, crashes, q, phi_d_deg, v_imp_cm_per_s, theta_imp_deg, "
    "expected_particle_steps, wanted, priority, wall_limit_s, wall_s FROM jobs";
constexpr const char* in_turn = " ORDER BY priority DESC, expected_particle_steps DESC, id";

/// The rows of a statement that begins with `select_jobs`.
std::vector<Job> job_rows(const Connection& connection, const std::string& text,
                          const std::function<void(SQLite::Statement&)>& bind) {
  std::vector<Job> rows;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, text);
    bind(select);
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
      job.wanted = enumerator<Wanted>(wanted_names, select.getColumn(9).getString());
      job.priority = select.getColumn(10).getInt();
      if (!select.getColumn(11).isNull()) job.wall_limit_s = select.getColumn(11).getDouble();
      job.wall_s = select.getColumn(12).getDouble();
      rows.push_back(std::move(job));
    }
  });
  return rows;
}

/// Schedulers on this machine call a worker by its process id; others do not.
std::int64_t process_id(const std::string& worker) {
  std::int64_t pid = 0;
  const auto [end, problem] = std::from_chars(worker.data(), worker.data() + worker.size(), pid);
  return problem == std::errc() && end == worker.data() + worker.size() ? pid : 0;
}

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
      message = ?, core_seconds = ?, particle_steps = ?, peak_memory_bytes = ?,
      host = coalesce(?, host), pid = coalesce(?, pid)
      WHERE job_id = ? AND ended IS NULL)");
  bind_all(update, name(exit_reason_names, end.reason), null_if_empty(end.failure_kind),
           null_if_empty(end.message), end.core_seconds, end.particle_steps, end.peak_memory_bytes,
           null_if_empty(end.host), end.pid, job);
  update.exec();
}

}  // namespace

AddedSweep add_sweep(Connection& connection, const std::string& name, const std::string& document,
                     std::span<const NewJob> new_jobs) {
  AddedSweep added;
  connection.write(
      [&](SQLite::Database& sql) { added = add_sweep(sql, name, document, new_jobs); });
  return added;
}

AddedSweep add_sweep(SQLite::Database& sql, const std::string& name, const std::string& document,
                     std::span<const NewJob> new_jobs) {
  AddedSweep added{.jobs = new_jobs.size()};
  added.sweep = sweep_id(sql, name, document);
  SQLite::Statement insert(sql, R"(INSERT OR IGNORE INTO jobs
        (hash, q, phi_d_deg, v_imp_cm_per_s, theta_imp_deg, v_over_v_esc, particles_per_target,
         seed, end_time_s, expected_particle_steps, fidelity, priority)
        VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?))");
  SQLite::Statement insert_scene(
      sql, "INSERT INTO job_scenes (job_id, scene) SELECT id, ? FROM jobs WHERE hash = ?");
  SQLite::Statement insert_settings(sql, R"(INSERT OR IGNORE INTO job_settings (scene)
        SELECT scene FROM shared_scenes WHERE job_id = (SELECT id FROM jobs WHERE hash = ?))");
  SQLite::Statement note_settings(sql, R"(UPDATE jobs SET settings =
        (SELECT s.id FROM job_settings s JOIN shared_scenes c ON c.scene = s.scene
         WHERE c.job_id = jobs.id) WHERE hash = ?)");
  SQLite::Statement join(sql,
                         "INSERT OR IGNORE INTO sweep_jobs (sweep_id, job_id) SELECT ?, id FROM "
                         "jobs WHERE hash = ?");
  for (const NewJob& j : new_jobs) {
    bind_all(insert, j.hash, j.q, j.phi_d_deg, j.v_imp_cm_per_s, j.theta_imp_deg, j.v_over_v_esc,
             j.particles_per_target, j.seed, j.end_time_s, j.expected_particle_steps,
             null_if_empty(j.fidelity), j.priority);
    if (insert.exec() == 1) {
      ++added.added;
      bind_all(insert_scene, j.scene, j.hash);
      insert_scene.exec();
      bind_all(insert_settings, j.hash);
      insert_settings.exec();
      bind_all(note_settings, j.hash);
      note_settings.exec();
    }
    bind_all(join, added.sweep, j.hash);
    join.exec();
  }
  SQLite::Statement label(sql, "SELECT label FROM sweep_labels WHERE id = ?");
  bind_all(label, added.sweep);
  label.executeStep();
  added.label = label.getColumn(0).getString();
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
  std::string text = select_jobs + " WHERE 1"s;
  if (filter.sweep) text += " AND id IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = :sweep_id)";
  if (filter.state) text += " AND state = :state";
  text += conditions(filter.selection) + in_turn;
  return job_rows(connection, text, [&](SQLite::Statement& select) {
    if (filter.sweep) select.bind(":sweep_id", *filter.sweep);
    if (filter.state) select.bind(":state", std::string(name(job_state_names, *filter.state)));
    bind_conditions(select, filter.selection);
  });
}

std::vector<Job> next_jobs(const Connection& connection, std::optional<std::int64_t> sweep,
                           std::size_t most) {
  std::string text = select_jobs + " WHERE state = 'pending' AND wanted = 'run'"s;
  if (sweep)
    text += " AND EXISTS (SELECT 1 FROM sweep_jobs WHERE sweep_id = :sweep_id AND job_id = id)";
  return job_rows(connection, text + in_turn + " LIMIT :most", [&](SQLite::Statement& select) {
    if (sweep) select.bind(":sweep_id", *sweep);
    select.bind(":most", static_cast<std::int64_t>(most));
  });
}

bool is_member(const Connection& connection, std::int64_t sweep, std::int64_t job) {
  bool member = false;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement find(sql, "SELECT 1 FROM sweep_jobs WHERE sweep_id = ? AND job_id = ?");
    bind_all(find, sweep, job);
    member = find.executeStep();
  });
  return member;
}

std::vector<Job> unwanted_jobs(const Connection& connection) {
  return job_rows(connection, select_jobs + " WHERE state = 'running' AND wanted <> 'run'"s,
                  [](SQLite::Statement&) {});
}

std::size_t JobCounts::total() const {
  return std::accumulate(in_state.begin(), in_state.end(), std::size_t{0});
}

JobCounts count_jobs(const Connection& connection, std::optional<std::int64_t> sweep) {
  JobCounts counts;
  std::string text = "SELECT state, wanted, count(*), sum(expected_particle_steps) FROM jobs";
  if (sweep) text += " WHERE id IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = :sweep_id)";
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, text + " GROUP BY state, wanted");
    if (sweep) select.bind(":sweep_id", *sweep);
    while (select.executeStep()) {
      const auto state = enumerator<JobState>(job_state_names, select.getColumn(0).getString());
      const auto wanted = enumerator<Wanted>(wanted_names, select.getColumn(1).getString());
      const auto jobs = static_cast<std::size_t>(select.getColumn(2).getInt64());
      counts.in_state.at(static_cast<std::size_t>(state)) += jobs;
      if (state != JobState::pending) continue;
      if (wanted == Wanted::run)
        counts.expected_particle_steps += select.getColumn(3).getDouble();
      else
        counts.paused += jobs;
    }
  });
  return counts;
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

void begin_attempts(Connection& connection, std::span<const Start> starts) {
  connection.write([&](SQLite::Database& sql) {
    SQLite::Statement insert(
        sql, "INSERT INTO attempts (job_id, host, pid, worker, version) VALUES (?, ?, ?, ?, ?)");
    for (const Start& start : starts) {
      set_state(sql, start.job, JobState::running);
      bind_all(insert, start.job, start.host, process_id(start.worker), start.worker,
               start.version);
      insert.exec();
    }
  });
}

JobState end_attempt(Connection& connection, std::int64_t job, const AttemptEnd& end,
                     JobState next) {
  JobState state = next;
  connection.write([&](SQLite::Database& sql) {
    SQLite::Statement wanted(sql, "SELECT wanted FROM jobs WHERE id = ?");
    bind_all(wanted, job);
    const bool cancelled = wanted.executeStep() &&
                           wanted.getColumn(0).getString() == name(wanted_names, Wanted::cancel);
    if (cancelled && next == JobState::pending) state = JobState::cancelled;
    set_state(sql, job, state);
    close_attempt(sql, job, end);
    SQLite::Statement count(sql,
                            "UPDATE jobs SET crashes = crashes + ?, wall_s = wall_s + ?, wanted = "
                            "iif(wanted = 'cancel', 'run', wanted) WHERE id = ?");
    bind_all(count, int{end.reason == ExitReason::crashed}, end.wall_s, job);
    count.exec();
  });
  return state;
}

void finish(Connection& connection, std::int64_t job, const AttemptEnd& end, const Result& result,
            std::span<const Remnant> remnants) {
  connection.write([&](SQLite::Database& sql) { finish(sql, job, end, result, remnants); });
}

void finish(SQLite::Database& sql, std::int64_t job, const AttemptEnd& end, const Result& result,
            std::span<const Remnant> remnants) {
  set_state(sql, job, JobState::done);
  sql.exec(fmt::format("UPDATE jobs SET wanted = 'run' WHERE id = {}", job));
  close_attempt(sql, job, end);
  insert_result(sql, job, result);
  insert_remnants(sql, job, remnants);
}

}  // namespace eerie::db
