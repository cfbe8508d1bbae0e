#include "db/jobs/doctor.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include "db/store/bind.hpp"
#include "db/store/migrations.hpp"

namespace eerie::db {

std::vector<std::string> broken_references(const Connection& connection) {
  std::vector<std::string> rows;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement check(sql, "PRAGMA foreign_key_check");
    while (check.executeStep())
      rows.push_back(fmt::format("row {} of {} names a row of {} that is not there",
                                 check.getColumn(1).getString(), check.getColumn(0).getString(),
                                 check.getColumn(2).getString()));
  });
  return rows;
}

std::vector<std::string> changed_views(const Connection& connection) {
  std::vector<std::string> names;
  connection.read([&](SQLite::Database& sql) { names = changed_views(sql); });
  return names;
}

void remake_views(Connection& connection) {
  connection.write([](SQLite::Database& sql) { remake_views(sql); });
}

bool has_open_attempt(const Connection& connection, std::int64_t job) {
  bool open = false;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement find(sql, "SELECT 1 FROM attempts WHERE job_id = ? AND ended IS NULL");
    bind_all(find, job);
    open = find.executeStep();
  });
  return open;
}

std::optional<ResultMark> result_of(const Connection& connection, std::int64_t job) {
  std::optional<ResultMark> mark;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement find(sql, "SELECT class, b_over_a, steps FROM job_results WHERE job_id = ?");
    bind_all(find, job);
    if (!find.executeStep()) return;
    mark = {find.getColumn(0).getString(), std::nullopt, find.getColumn(2).getInt64()};
    if (!find.getColumn(1).isNull()) mark->b_over_a = find.getColumn(1).getDouble();
  });
  return mark;
}

}  // namespace eerie::db
