#include "db/jobs/merge.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <map>
#include <optional>
#include <sstream>

#include "db/store/bind.hpp"
#include "db/store/row_copy.hpp"

namespace eerie::db {
namespace {

/// "0.10.2" as {0, 10, 2}, so that it is newer than "0.9".
std::vector<int> numbers_of(const std::string& version) {
  std::vector<int> numbers;
  std::istringstream in(version);
  for (std::string part; std::getline(in, part, '.');) numbers.push_back(std::atoi(part.c_str()));
  return numbers;
}
bool is_newer(const std::string& a, const std::string& b) { return numbers_of(a) > numbers_of(b); }

/// A result by the numbers that tell it from another one.
struct Known {
  std::string version, outcome_class;
  double m_lr = 0;
  std::optional<double> b_over_a;
  std::int64_t steps = 0;
  bool operator==(const Known&) const = default;
};

class ResultOf {
 public:
  explicit ResultOf(SQLite::Database& sql)
      : select_(sql,
                "SELECT solver_version, class, m_lr_over_m_total, b_over_a, steps FROM job_results "
                "WHERE job_id = ?") {}
  std::optional<Known> operator()(std::int64_t job) {
    bind_all(select_, job);
    if (!select_.executeStep()) return std::nullopt;
    Known known{select_.getColumn(0).getString(), select_.getColumn(1).getString(),
                select_.getColumn(2).getDouble(), std::nullopt, select_.getColumn(4).getInt64()};
    if (!select_.getColumn(3).isNull()) known.b_over_a = select_.getColumn(3).getDouble();
    return known;
  }

 private:
  SQLite::Statement select_;
};

class Merge {
 public:
  Merge(SQLite::Database& from, SQLite::Database& to)
      : from_(from),
        to_(to),
        their_result_(from),
        our_result_(to),
        results_(from, to, {"job_results", "job_id"}),
        remnants_(from, to, {"job_remnants", "job_id"}) {}

  Merged all() {
    sweeps();
    settings();
    jobs();
    members();
    requests();
    solver_version();
    return std::move(merged_);
  }

 private:
  void sweeps() {
    SQLite::Statement select(from_, "SELECT id, name, document, created FROM sweeps ORDER BY id");
    SQLite::Statement insert(
        to_, "INSERT OR IGNORE INTO sweeps (name, document, created) VALUES (?, ?, ?)");
    SQLite::Statement find(to_, "SELECT id FROM sweeps WHERE name = ? AND document = ?");
    while (select.executeStep()) {
      const std::string name = select.getColumn(1), document = select.getColumn(2);
      bind_all(insert, name, document, select.getColumn(3).getString());
      insert.exec();
      bind_all(find, name, document);
      find.executeStep();
      sweep_[select.getColumn(0).getInt64()] = find.getColumn(0).getInt64();
    }
  }

  void settings() {
    SQLite::Statement select(from_, "SELECT id, scene FROM job_settings ORDER BY id");
    SQLite::Statement insert(to_, "INSERT OR IGNORE INTO job_settings (scene) VALUES (?)");
    SQLite::Statement find(to_, "SELECT id FROM job_settings WHERE scene = ?");
    while (select.executeStep()) {
      const std::string scene = select.getColumn(1);
      bind_all(insert, scene);
      insert.exec();
      bind_all(find, scene);
      find.executeStep();
      settings_[select.getColumn(0).getInt64()] = find.getColumn(0).getInt64();
    }
  }

  void jobs() {
    // What one database runs is no work of the other one.
    const std::vector<std::string> columns =
        table_columns(from_, "jobs", {"id", "state", "wanted", "settings"});
    const std::string names = fmt::format("{}", fmt::join(columns, ", "));
    SQLite::Statement select(from_, fmt::format(R"(SELECT id, hash, settings,
        iif(state = 'running', iif(wanted = 'cancel', 'cancelled', 'pending'), state) AS state,
        iif(wanted = 'cancel', 'run', wanted) AS wanted, {} FROM jobs ORDER BY id)",
                                                names));
    SQLite::Statement insert(
        to_,
        fmt::format("INSERT INTO jobs (settings, state, wanted, {}) VALUES (:settings, :state, "
                    ":wanted, :{})",
                    names, fmt::join(columns, ", :")));
    SQLite::Statement find(to_, "SELECT id FROM jobs WHERE hash = ?");
    RowCopy scenes(from_, to_, {"job_scenes", "job_id"});
    RowCopy attempts(from_, to_,
                     {"attempts",
                      "job_id",
                      {"id"},
                      "ended IS NOT NULL",
                      "EXISTS (SELECT 1 FROM attempts WHERE job_id = :job_id AND host = :host AND "
                      "pid = :pid AND started = :started)"});
    while (select.executeStep()) {
      ++merged_.jobs;
      const std::int64_t theirs = select.getColumn(0).getInt64();
      const std::string hash = select.getColumn(1);
      bind_all(find, hash);
      const bool is_known = find.executeStep();
      if (is_known) {
        const std::int64_t ours = find.getColumn(0).getInt64();
        known(hash, theirs, ours);
        job_[theirs] = ours;
      } else {
        insert.reset();
        for (int k = 3; k < select.getColumnCount(); ++k)
          bind_column(insert, select.getColumnName(k), select.getColumn(k));
        if (select.getColumn(2).isNull())
          insert.bind(":settings");
        else
          insert.bind(":settings", settings_.at(select.getColumn(2).getInt64()));
        insert.exec();
        job_[theirs] = to_.getLastInsertRowid();
        scenes(theirs, job_[theirs]);
        if (their_result_(theirs)) take_result(theirs, job_[theirs]);
        merged_.taken.push_back(hash);
        ++merged_.added;
      }
      merged_.attempts += attempts(theirs, job_[theirs]);
    }
  }

  /// A job that both have.
  void known(const std::string& hash, std::int64_t theirs, std::int64_t ours) {
    const std::optional<Known> their_result = their_result_(theirs), our_result = our_result_(ours);
    if (their_result && (!our_result || is_newer(their_result->version, our_result->version))) {
      take_result(theirs, ours);
      merged_.taken.push_back(hash);
      to_.exec(fmt::format("UPDATE jobs SET state = 'done', wanted = 'run' WHERE id = {}", ours));
    } else if (their_result && their_result->version == our_result->version) {
      if (their_result != our_result) merged_.differing.push_back(hash);
    } else if (!their_result && !our_result && is_tried(from_, theirs) && !is_tried(to_, ours)) {
      take_progress(theirs, ours);
      merged_.taken.push_back(hash);
    }
  }

  void take_result(std::int64_t theirs, std::int64_t ours) {
    for (const char* table : {"job_results", "job_remnants"})
      to_.exec(fmt::format("DELETE FROM {} WHERE job_id = {}", table, ours));
    results_(theirs, ours);
    remnants_(theirs, ours);
    ++merged_.results;
  }

  static bool is_tried(SQLite::Database& sql, std::int64_t job) {
    SQLite::Statement find(sql, "SELECT 1 FROM attempts WHERE job_id = ?");
    bind_all(find, job);
    return find.executeStep();
  }

  void take_progress(std::int64_t theirs, std::int64_t ours) {
    SQLite::Statement select(from_, R"(SELECT iif(state = 'running', 'pending', state) AS state,
        crashes, wall_s FROM jobs WHERE id = ?)");
    bind_all(select, theirs);
    select.executeStep();
    SQLite::Statement update(
        to_, "UPDATE jobs SET state = :state, crashes = :crashes, wall_s = :wall_s WHERE id = :id");
    for (int k = 0; k < select.getColumnCount(); ++k)
      bind_column(update, select.getColumnName(k), select.getColumn(k));
    update.bind(":id", ours);
    update.exec();
  }

  void members() {
    SQLite::Statement select(from_, "SELECT sweep_id, job_id FROM sweep_jobs");
    SQLite::Statement insert(to_,
                             "INSERT OR IGNORE INTO sweep_jobs (sweep_id, job_id) VALUES (?, ?)");
    while (select.executeStep()) {
      bind_all(insert, sweep_.at(select.getColumn(0).getInt64()),
               job_.at(select.getColumn(1).getInt64()));
      insert.exec();
    }
  }

  void requests() {
    SQLite::Statement select(from_, "SELECT id, kind, applied, answer FROM requests");
    SQLite::Statement insert(
        to_, "INSERT OR IGNORE INTO requests (id, kind, applied, answer) VALUES (?, ?, ?, ?)");
    while (select.executeStep()) {
      bind_all(insert, select.getColumn(0).getString(), select.getColumn(1).getString(),
               select.getColumn(2).getString(), select.getColumn(3).getString());
      insert.exec();
    }
  }

  /// Results are stale beside the newest solver that worked on either.
  void solver_version() {
    const auto version_in = [](SQLite::Database& sql) {
      SQLite::Statement find(sql, "SELECT value FROM settings WHERE key = 'solver_version'");
      return find.executeStep() ? find.getColumn(0).getString() : std::string();
    };
    const std::string theirs = version_in(from_), ours = version_in(to_);
    if (theirs.empty() || (!ours.empty() && !is_newer(theirs, ours))) return;
    SQLite::Statement insert(
        to_, "INSERT OR REPLACE INTO settings (key, value) VALUES ('solver_version', ?)");
    bind_all(insert, theirs);
    insert.exec();
  }

  SQLite::Database &from_, &to_;
  ResultOf their_result_, our_result_;
  RowCopy results_, remnants_;
  std::map<std::int64_t, std::int64_t> sweep_, settings_, job_;  ///< their id to ours
  Merged merged_;
};

}  // namespace

Merged merge(SQLite::Database& from, SQLite::Database& to) { return Merge(from, to).all(); }

}  // namespace eerie::db
