#include "db/jobs/control.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "db/store/bind.hpp"

namespace eerie::db {
namespace {

/// UPDATE jobs SET `change` WHERE `of` and the selection hold.
std::size_t update(SQLite::Database& sql, const char* change, const char* of,
                   const Selection& selection,
                   const std::function<void(SQLite::Statement&)>& bind = {}) {
  SQLite::Statement statement(
      sql, std::string("UPDATE jobs SET ") + change + " WHERE " + of + conditions(selection));
  bind_conditions(statement, selection);
  if (bind) bind(statement);
  return static_cast<std::size_t>(statement.exec());
}

constexpr const char* clean_slate = "state = 'pending', wanted = 'run', crashes = 0, wall_s = 0";

}  // namespace

std::size_t pause(SQLite::Database& sql, const Selection& selection) {
  return update(sql, "wanted = 'pause'", "state IN ('pending', 'running') AND wanted = 'run'",
                selection);
}

std::size_t resume(SQLite::Database& sql, const Selection& selection) {
  return update(sql, "wanted = 'run'", "state IN ('pending', 'running') AND wanted = 'pause'",
                selection);
}

std::size_t cancel(SQLite::Database& sql, const Selection& selection) {
  const std::size_t running =
      update(sql, "wanted = 'cancel'", "state = 'running' AND wanted <> 'cancel'", selection);
  return running + update(sql, "state = 'cancelled', wanted = 'run'",
                          "state IN ('pending', 'failed')", selection);
}

std::size_t retry(SQLite::Database& sql, const Selection& selection) {
  return update(sql, clean_slate, "state IN ('failed', 'cancelled')", selection);
}

std::size_t retry_failed(Connection& connection, std::int64_t sweep) {
  std::size_t count = 0;
  connection.write([&](SQLite::Database& sql) {
    count = update(sql, clean_slate,
                   "state = 'failed' AND id IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = "
                   ":sweep_id)",
                   {}, [&](SQLite::Statement& s) { s.bind(":sweep_id", sweep); });
  });
  return count;
}

std::size_t rerun_stale(SQLite::Database& sql, const Selection& selection) {
  return update(sql, clean_slate,
                "state = 'done' AND id IN (SELECT job_id FROM job_results WHERE solver_version <> "
                "(SELECT value FROM settings WHERE key = 'solver_version'))",
                selection);
}

std::size_t set_priority(SQLite::Database& sql, const Selection& selection, int priority) {
  return update(sql, "priority = :priority", "priority <> :priority", selection,
                [&](SQLite::Statement& s) { s.bind(":priority", priority); });
}

std::size_t set_wall_limit(SQLite::Database& sql, const Selection& selection,
                           std::optional<double> limit_s) {
  return update(sql, "wall_limit_s = :limit, wall_s = 0", "state <> 'done'", selection,
                [&](SQLite::Statement& s) {
                  if (limit_s)
                    s.bind(":limit", *limit_s);
                  else
                    s.bind(":limit");
                });
}

void prepare_new_jobs(SQLite::Database& sql, std::int64_t sweep, std::optional<int> priority,
                      std::optional<double> wall_limit_s) {
  SQLite::Statement statement(sql, R"(UPDATE jobs SET priority = coalesce(?, priority),
      wall_limit_s = coalesce(?, wall_limit_s)
      WHERE state = 'pending' AND id IN (SELECT job_id FROM sweep_jobs WHERE sweep_id = ?)
        AND NOT EXISTS (SELECT 1 FROM attempts WHERE job_id = jobs.id))");
  bind_all(statement, priority, wall_limit_s, sweep);
  statement.exec();
}

std::string once(Connection& connection, const std::string& id, const std::string& kind,
                 const std::function<std::string(SQLite::Database&)>& body) {
  std::string text;
  connection.write([&](SQLite::Database& sql) {
    SQLite::Statement find(sql, "SELECT answer FROM requests WHERE id = ?");
    bind_all(find, id);
    if (find.executeStep()) {
      text = find.getColumn(0).getString();
      return;
    }
    text = body(sql);
    SQLite::Statement insert(sql, "INSERT INTO requests (id, kind, answer) VALUES (?, ?, ?)");
    bind_all(insert, id, kind, text);
    insert.exec();
  });
  return text;
}

std::optional<std::string> answer(const Connection& connection, const std::string& id) {
  std::optional<std::string> text;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement find(sql, "SELECT answer FROM requests WHERE id = ?");
    bind_all(find, id);
    if (find.executeStep()) text = find.getColumn(0).getString();
  });
  return text;
}

}  // namespace eerie::db
