#include "db/jobs/extension.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <string>
#include <utility>
#include <vector>

#include "db/jobs/jobs.hpp"
#include "db/store/bind.hpp"

namespace eerie::db {

void add_extension(SQLite::Database& sql, std::int64_t job, const NewJob& later) {
  SQLite::Statement select(sql, R"(SELECT name, document FROM sweeps
      WHERE id IN (SELECT sweep_id FROM sweep_jobs WHERE job_id = ?) ORDER BY id)");
  bind_all(select, job);
  std::vector<std::pair<std::string, std::string>> sweeps;
  while (select.executeStep())
    sweeps.emplace_back(select.getColumn(0).getString(), select.getColumn(1).getString());
  for (const auto& [name, document] : sweeps) add_sweep(sql, name, document, {&later, 1});
}

}  // namespace eerie::db
