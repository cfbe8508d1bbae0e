#include "db/jobs/job_settings.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "db/jobs/jobs.hpp"
#include "db/store/migrations.hpp"

namespace eerie::db {

std::vector<JobSettings> job_settings(const Connection& connection) {
  std::vector<JobSettings> all;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, R"(
        SELECT s.id, max(j.fidelity), s.scene
        FROM job_settings s LEFT JOIN jobs j ON j.settings = s.id GROUP BY s.id ORDER BY s.id)");
    while (select.executeStep())
      all.push_back({select.getColumn(0).getInt64(), select.getColumn(1).getString(),
                     select.getColumn(2).getString()});
  });
  return all;
}

std::size_t count_settings(std::span<const NewJob> jobs) {
  // A database of its own: the rule stands in the schema alone.
  SQLite::Database sql(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  migrate(sql);
  add_sweep(sql, "", "", jobs);
  return static_cast<std::size_t>(sql.execAndGet("SELECT count(*) FROM job_settings").getInt());
}

}  // namespace eerie::db
