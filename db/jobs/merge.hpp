#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace eerie::db {

/// What a merge took from one database into another.
struct Merged {
  std::size_t jobs = 0;      ///< jobs of the other database
  std::size_t added = 0;     ///< of these, jobs that are new
  std::size_t results = 0;   ///< results that it took, for new jobs or for known ones
  std::size_t attempts = 0;  ///< attempts that it took
  /// Hashes of jobs whose files the other database has now: new jobs, and known ones with what was
  /// taken for them.
  std::vector<std::string> taken;
  /// Hashes of jobs with a result in both, of one solver version, whose numbers differ. Those that
  /// were there stay.
  std::vector<std::string> differing;
};

/// Puts everything of `from` into `to`, which have the same schema: sweeps, jobs, results,
/// remnants, attempts and requests. A job is known by its hash, a sweep by its name and document,
/// an attempt by its host, process and start, so nothing is there twice, however often it is
/// merged. Of two results that of the newer solver version is taken. Jobs that run in `from` are
/// pending in `to`, and attempts without an end are left out. Runs inside a transaction of the
/// caller on either side.
Merged merge(SQLite::Database& from, SQLite::Database& to);

}  // namespace eerie::db
