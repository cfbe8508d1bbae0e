#include "campaign/manager/doctor.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/manager/attempts/attempt_verdict.hpp"
#include "db/jobs/doctor.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/migrations.hpp"
#include "db/store/settings.hpp"
#include "db/store/upgrade.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/free_space.hpp"
#include "solver/base/text/shell_word.hpp"
#include "solver/base/version.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;

namespace {

/// One examination. With `writer` what is safe is mended on the way.
class Examination {
 public:
  Examination(const db::Connection& reader, db::Connection* writer)
      : reader_(reader), writer_(writer), folder_(job_folder::job_folder(reader)) {}

  std::vector<Problem> whole(const Examined& examined) {
    database();
    disks();
    const std::vector<db::Job> jobs = db::jobs(reader_, {});
    std::size_t done = 0;
    for (const db::Job& job : jobs) {
      known_.insert(folder_.of(job.hash).path.filename());
      look_at(job);
      examined(++done, jobs.size());
    }
    strangers();
    return std::move(findings_);
  }

 private:
  void find(std::string what, std::string mend) {
    findings_.push_back({std::move(what), std::move(mend)});
  }
  void note(std::string what, std::string mend) {
    findings_.push_back({std::move(what), std::move(mend), false, false, true});
  }
  /// A finding that `body` mends, where mending is asked for.
  void find_mendable(std::string what, std::string mend, const std::function<void()>& body) {
    if (writer_ != nullptr) body();
    findings_.push_back({std::move(what), std::move(mend), true, writer_ != nullptr});
  }

  void database() {
    if (const std::string verdict = reader_.integrity(); verdict != "ok")
      find(fmt::format("database {}: {}", reader_.path().string(), verdict),
           "restore a copy, or make a new database and submit the sweeps again: results are taken "
           "from the job directories");
    for (const std::string& broken : db::broken_references(reader_))
      find(fmt::format("database {}: {}", reader_.path().string(), broken), "restore a copy");
    if (const int schema = db::schema_of_file(reader_.path()); schema < db::latest_version())
      note(fmt::format("database {}: it has schema {} of an older eerie, this one's is {}",
                       reader_.path().string(), schema, db::latest_version()),
           "it is read as it is; what writes to it (`run`, `daemon`, `doctor --fix`) changes its "
           "schema and keeps a copy");
    if (const std::vector<std::string> views = db::changed_views(reader_); !views.empty())
      find_mendable(fmt::format("database {}: somebody has changed or removed the view{} {}",
                                reader_.path().string(), views.size() == 1 ? "" : "s",
                                fmt::join(views, ", ")),
                    "made anew: views hold no data", [&] { db::remake_views(*writer_); });
    const auto made_by = db::setting(reader_, "solver_version");
    if (made_by && *made_by != solver_version)
      note(fmt::format("this program's solver is version {}, the database was last worked on with "
                       "version {}",
                       solver_version, *made_by),
           fmt::format("the next run marks older results stale; `eerie retry --stale --all --db "
                       "{}` repeats them",
                       shell_word(reader_.path().string())));
  }

  void disks() {
    constexpr std::uintmax_t little = 1'000'000'000;
    for (const fs::path& folder : {fs::absolute(reader_.path()).parent_path(), folder_.root})
      if (const auto free = free_bytes(folder); free && *free < little)
        note(
            fmt::format("{} has {:.0f} MB free", folder.string(), static_cast<double>(*free) / 1e6),
            "free some: a job needs room for its snapshots");
  }

  void look_at(const db::Job& job) {
    const job_folder::JobDirectory directory = folder_.of(job.hash);
    const std::string name = job.hash.substr(0, 16);
    const bool busy = job_folder::WorkerLock::held(directory);
    if (!busy) remove_leftovers(directory.path);
    if (job.state == db::JobState::running && !busy) running_without_worker(job, directory);
    if (job.state == db::JobState::done) look_at_result(job, directory);
    if (job.state == db::JobState::pending && !busy && job_folder::read_result(directory, job.hash))
      find_mendable(fmt::format("job {} has a result that the database does not know", name),
                    "taken into the database",
                    [&] { commit(*writer_, job, judge_attempt(directory, job.hash, {}), {}); });
    if (job.state != db::JobState::running && db::has_open_attempt(reader_, job.id))
      find_mendable(
          fmt::format("job {} is {} and has an attempt without an end", name,
                      db::job_state_names.at(static_cast<std::size_t>(job.state))),
          "ended as lost",
          [&] { db::end_attempt(*writer_, job.id, {.reason = db::ExitReason::lost}, job.state); });
    if (!busy) look_at_checkpoint(directory);
  }

  void running_without_worker(const db::Job& job, const job_folder::JobDirectory& directory) {
    find_mendable(fmt::format("job {} counts as running and has no worker on this machine",
                              job.hash.substr(0, 16)),
                  "judged by its files; it goes on from its checkpoint",
                  [&] { commit(*writer_, job, judge_attempt(directory, job.hash, {}), {}); });
  }

  void look_at_result(const db::Job& job, const job_folder::JobDirectory& directory) {
    const std::string name = job.hash.substr(0, 16);
    const auto in_database = db::result_of(reader_, job.id);
    if (!in_database) {
      find_mendable(fmt::format("job {} counts as done and has no result", name), "pending again",
                    [&] {
                      db::end_attempt(*writer_, job.id, {.reason = db::ExitReason::lost},
                                      db::JobState::pending);
                    });
      return;
    }
    const auto in_file = job_folder::read_result(directory, job.hash);
    if (!in_file) {
      find(fmt::format("{} is missing or damaged; the database has its numbers",
                       directory.result().string()),
           "nothing is lost but the provenance; cancel and rerun the job to have it again");
    } else if (in_file->result.b_over_a != in_database->b_over_a ||
               in_file->result.outcome_class != in_database->outcome_class ||
               in_file->result.steps != in_database->steps) {
      find_mendable(fmt::format("{} and the database disagree", directory.result().string()),
                    "the file's numbers were taken: its worker wrote them", [&] {
                      db::finish(*writer_, job.id, {.reason = db::ExitReason::finished},
                                 in_file->result, in_file->remnants);
                    });
    }
  }

  void look_at_checkpoint(const job_folder::JobDirectory& directory) {
    std::error_code ignored;
    if (!fs::exists(directory.checkpoint(), ignored)) return;
    try {
      io::read_snapshot(directory.checkpoint());
    } catch (const std::exception& error) {
      find_mendable(fmt::format("{}", error.what()),
                    "removed; the job goes on from an older one or from its start",
                    [&] { fs::remove(directory.checkpoint()); });
    }
  }

  /// What writers that were killed left half written.
  void remove_leftovers(const fs::path& folder) {
    for (const fs::path& half : half_written_files(folder))
      find_mendable(fmt::format("{} was left half written", half.string()), "removed",
                    [&] { fs::remove(half); });
  }

  /// Directories that belong to no job.
  void strangers() {
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder_.root, missing))
      if (entry.is_directory() && entry.path().filename() != "batches" &&
          entry.path() != folder_.bodies() && !known_.contains(entry.path().filename()))
        find(fmt::format("{} belongs to no job of the database", entry.path().string()),
             "submit its sweep again, and its result is taken over; or remove it");
  }

  const db::Connection& reader_;
  db::Connection* writer_;
  job_folder::JobFolder folder_;
  std::set<std::string> known_;
  std::vector<Problem> findings_;
};

}  // namespace

std::vector<Problem> examine(const db::Connection& connection, const Examined& examined) {
  return Examination(connection, nullptr).whole(examined);
}

std::vector<Problem> mend(db::Connection& connection, const Examined& examined) {
  return Examination(connection, &connection).whole(examined);
}

}  // namespace eerie::manager
