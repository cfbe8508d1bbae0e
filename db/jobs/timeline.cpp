#include "db/jobs/timeline.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

namespace eerie::db {

std::vector<WorkSpan> newest_work(const Connection& connection, std::size_t most) {
  std::vector<WorkSpan> spans;
  connection.read([&](SQLite::Database& sql) {
    SQLite::Statement select(sql, R"(
        SELECT j.hash, a.host, a.worker, a.started, a.ended, a.exit_reason, a.failure_kind
        FROM attempts a JOIN jobs j ON j.id = a.job_id ORDER BY a.id DESC LIMIT ?)");
    select.bind(1, static_cast<std::int64_t>(most));
    const auto text = [&](int column) { return select.getColumn(column).getString(); };
    while (select.executeStep())
      spans.push_back({text(0), text(1), text(2), text(3), text(4), text(5), text(6)});
  });
  return spans;
}

}  // namespace eerie::db
