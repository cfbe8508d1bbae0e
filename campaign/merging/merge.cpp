#include "campaign/merging/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/merging/job_files.hpp"
#include "campaign/text/given_folder.hpp"
#include "db/store/connection.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/kill_point.hpp"

namespace eerie::merging {
namespace fs = std::filesystem;

namespace {

using Sources = std::vector<std::unique_ptr<db::Connection>>;

/// All of them are there and can be read, before anything is written.
Sources opened(const std::vector<fs::path>& databases) {
  Sources sources;
  for (const fs::path& database : databases)
    sources.push_back(std::make_unique<db::Connection>(database, db::Access::read));
  return sources;
}

void require_different(const std::vector<fs::path>& databases) {
  for (std::size_t i = 0; i < databases.size(); ++i)
    for (std::size_t j = i + 1; j < databases.size(); ++j) {
      std::error_code ignored;
      if (!fs::equivalent(databases[i], databases[j], ignored)) continue;
      throw InputError(fmt::format("{} and {} are one database; give each once",
                                   databases[i].string(), databases[j].string()));
    }
}

/// Makes the job directories of what was taken findable in the target's job folder.
void bring_files(const db::Connection& source, const job_folder::JobFolder& target,
                 const MergeOptions& options, SourceReport& report) {
  if (report.merged.taken.empty()) return;
  job_folder::require_usable(target.root);
  const job_folder::JobFolder origin = job_folder::job_folder(source);
  const Transfer how = options.copies_files ? Transfer::copy : Transfer::link;
  for (const std::string& hash : report.merged.taken)
    ++(transfer(origin.of(hash), target.of(hash), how) ? report.files : report.missing);
}

std::vector<SourceReport> merge_all(const Sources& sources, db::Connection& target,
                                    const job_folder::JobFolder& folder,
                                    const MergeOptions& options) {
  std::vector<SourceReport> reports;
  target.write([&](SQLite::Database& to) {
    for (const auto& source : sources) {
      SourceReport& report = reports.emplace_back();
      report.database = source->path();
      source->read([&](SQLite::Database& from) { report.merged = db::merge(from, to); });
      bring_files(*source, folder, options, report);
    }
    kill_point("merge.before-commit");
  });
  return reports;
}

/// The endings of the files that SQLite puts beside a database.
constexpr const char* of_sqlite[] = {"-wal", "-shm", "-journal"};

/// A database under a passing name, and what SQLite and the lock put beside it.
void remove_database(const fs::path& database) {
  std::error_code ignored;
  for (const char* ending : {"", ".lock"}) fs::remove(database.string() + ending, ignored);
  for (const char* ending : of_sqlite) fs::remove(database.string() + ending, ignored);
}

}  // namespace

std::vector<SourceReport> merge_into(const fs::path& target, const std::vector<fs::path>& sources,
                                     const MergeOptions& options) {
  std::vector<fs::path> all = sources;
  all.insert(all.begin(), target);
  require_different(all);
  const Sources opened_sources = opened(sources);
  db::Connection(target, db::Access::read_any);  // there, and ours
  const db::Lock lock(target);
  db::Connection connection(target, db::Access::write);
  return merge_all(opened_sources, connection, job_folder::job_folder(connection), options);
}

std::vector<SourceReport> merge_as(const fs::path& target, const std::vector<fs::path>& sources,
                                   const MergeOptions& options) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(target, ignored)))
    throw InputError(fmt::format(
        "-o {}: it is there already; give a new file, or name it first without -o: then it takes "
        "in the others",
        target.string()));
  require_different(sources);
  text::require_folder_of(target);
  const Sources opened_sources = opened(sources);
  const fs::path unfinished =
      fs::absolute(target).parent_path() / fmt::format(".{}.merging", target.filename().string());
  std::vector<SourceReport> reports;
  const db::Lock lock(unfinished);  // of another merge into the same file
  try {
    fs::resize_file(unfinished, 0);  // what a merge that was killed has left
    for (const char* ending : of_sqlite) fs::remove(unfinished.string() + ending);
    {
      db::Connection connection(unfinished, db::Access::write);
      reports =
          merge_all(opened_sources, connection, {fs::path(target.string() + ".jobs")}, options);
    }
    kill_point("merge.before-install");
    replace_file(unfinished, target);
  } catch (...) {
    remove_database(unfinished);
    throw;
  }
  remove_database(unfinished);
  return reports;
}

}  // namespace eerie::merging
