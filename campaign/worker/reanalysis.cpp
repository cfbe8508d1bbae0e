#include "campaign/worker/reanalysis.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "campaign/job_folder/result_file.hpp"
#include "campaign/text/json_file.hpp"
#include "db/jobs/job_results.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/sha256.hpp"
#include "solver/base/text/shell_word.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::worker {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// The document with another analysis, under its own checksum.
std::string with_analysis(json document, const remnants::Analysis& analysis) {
  document["analysis"] = remnants::to_json(analysis);
  document["version"] = job_folder::result_version;
  document.erase("sha256");
  document["sha256"] = sha256_hex(document.dump());
  return document.dump(1) + "\n";
}

void reanalyse(db::Connection& connection, const db::Job& job,
               const job_folder::JobDirectory& directory) {
  if (!job_folder::read_result(directory, job.hash))
    throw InputError(
        fmt::format("{}: is missing, damaged, or of another scene; `eerie doctor --db {}` "
                    "says what to do",
                    directory.result().string(), shell_word(connection.path().string())));
  const io::Snapshot last = io::read_snapshot(directory.final_snapshot());
  const remnants::Analysis analysis =
      analyse_run(directory, last, job_folder::read_history(directory.history()));
  const std::string text =
      with_analysis(text::parse_json(read_file(directory.result()), "result.json"), analysis);
  const auto stored = job_folder::parse_result(text, job.hash);
  if (!stored) throw EnvironmentError(directory.result().string() + ": cannot be written anew");
  install_text(directory.result(), text);
  db::replace_analysis(connection, job.id, stored->result, stored->remnants);
}

/// The first snapshot of the run; nothing where there is none that fits. Only depths of origin
/// need it: no result is lost for the want of them.
std::optional<io::Snapshot> start_of(const job_folder::JobDirectory& directory,
                                     const io::Snapshot& last) {
  const fs::path file = directory.first_snapshot();
  if (!fs::exists(file)) return std::nullopt;
  try {
    io::Snapshot first = io::read_snapshot(file);
    if (first.state.size() == last.state.size() && first.scene.impact.q == last.scene.impact.q)
      return first;
    spdlog::warn("{}: of another run; origin depths are left out", file.string());
  } catch (const InputError& error) {
    spdlog::warn("{}; origin depths are left out", error.what());
  }
  return std::nullopt;
}

}  // namespace

remnants::Analysis analyse_run(const job_folder::JobDirectory& directory, const io::Snapshot& last,
                               const std::vector<job_folder::HistoryRow>& history) {
  const std::optional<io::Snapshot> first = start_of(directory, last);
  return remnants::analyse_in_detail(
      last, first ? &*first : nullptr,
      job_folder::separated_after_contact(history, last.scene.impact.q));
}

Reanalysis reanalyse(db::Connection& connection,
                     const std::function<void(std::size_t, std::size_t)>& on_progress) {
  const job_folder::JobFolder folder = job_folder::job_folder(connection);
  std::vector<db::Job> jobs = db::jobs(connection, {});
  std::erase_if(jobs, [](const db::Job& job) { return job.state != db::JobState::done; });
  Reanalysis report;
  std::size_t done = 0;
  for (const db::Job& job : jobs) {
    try {
      reanalyse(connection, job, folder.of(job.hash));
      ++report.analysed;
    } catch (const InputError& error) {  // its files are gone or damaged: the others have theirs
      report.skipped.push_back(fmt::format("job {}: {}", job.id, error.what()));
    }
    on_progress(++done, jobs.size());
  }
  return report;
}

}  // namespace eerie::worker
