#include <algorithm>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/text/plain_text.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

struct LogArguments {
  fs::path database;
  std::string job;
  bool follow = false;
};

/// Prints the lines that stand behind `offset`, made plain, and where it is `over` also one that
/// does not end; returns where it ended. A log that was made anew, and so is shorter, is printed
/// from its start.
std::size_t print_from(const fs::path& path, std::size_t offset, bool over, Output& out) {
  if (!fs::exists(path)) return offset;
  std::string text = read_file(path);
  if (text.size() < offset) offset = 0;
  if (!over) text.erase(std::max(text.rfind('\n') + 1, offset));
  out.write(text::plain_lines(std::string_view(text).substr(offset)));
  return text.size();
}

bool is_over(const db::Connection& connection, const db::Job& job) {
  for (const db::Job& now : db::jobs(connection, {.selection = {.hashes = {job.hash}}}))
    return now.state != db::JobState::pending && now.state != db::JobState::running;
  return true;
}

Answer log(const LogArguments& a, Output& out) {
  const db::Connection connection(a.database, db::Access::read);
  const db::Job job = queries::find_job(connection, a.job);
  const job_folder::JobDirectory directory = job_folder::job_folder(connection).of(job.hash);
  if (!a.follow && !fs::exists(directory.log()))
    throw InputError(
        fmt::format("job {} has no log yet: it was never started", job.hash.substr(0, 16)));
  if (a.follow) process::catch_stop_signals(), process::hold_signals();
  std::size_t offset = print_from(directory.log(), 0, !a.follow, out);
  while (a.follow && process::stop_requests() == 0 && !out.is_over()) {
    const bool over = is_over(connection, job);
    offset = print_from(directory.log(), offset, over, out);
    if (over) break;
    process::wait_for_signal(std::chrono::milliseconds(500));
  }
  return {};
}

}  // namespace

Action add_log(CLI::App& app) {
  auto a = std::make_shared<LogArguments>();
  app.add_option("JOB", a->job, "the first digits of the job's hash")->required();
  add_database(app, a->database);
  app.add_flag("-f,--follow", a->follow, "go on printing until the job is over");
  return [a](Output& out) { return log(*a, out); };
}

}  // namespace eerie::cli
