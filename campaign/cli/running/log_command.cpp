#include <fmt/format.h>

#include <cstdio>
#include <fstream>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/find_job.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/process/signals.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

struct LogArguments {
  fs::path database;
  std::string job;
  bool follow = false;
};

/// Prints what stands behind `offset`; returns where it ended. A log that was made anew, and so is
/// shorter, is printed from its start.
std::streamoff print_from(const fs::path& path, std::streamoff offset) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (!in) return offset;
  const std::streamoff size = in.tellg();
  in.seekg(size < offset ? 0 : offset);
  std::string chunk(1 << 16, '\0');
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0)
    std::fwrite(chunk.data(), 1, static_cast<std::size_t>(in.gcount()), stdout);
  std::fflush(stdout);
  return size;
}

bool is_over(const db::Connection& connection, const db::Job& job) {
  for (const db::Job& now : db::jobs(connection, {.selection = {.hashes = {job.hash}}}))
    return now.state != db::JobState::pending && now.state != db::JobState::running;
  return true;
}

int log(const LogArguments& a) {
  const db::Connection connection(a.database, db::Access::read);
  const db::Job job = find_job(connection, a.job);
  const job_folder::JobDirectory directory = job_folder::job_folder(connection).of(job.hash);
  if (!a.follow && !fs::exists(directory.log()))
    throw InputError(
        fmt::format("job {} has no log yet: it was never started", job.hash.substr(0, 16)));
  if (a.follow) process::catch_stop_signals(), process::hold_signals();
  std::streamoff offset = print_from(directory.log(), 0);
  while (a.follow && process::stop_requests() == 0) {
    const bool over = is_over(connection, job);
    offset = print_from(directory.log(), offset);
    if (over) break;
    process::wait_for_signal(std::chrono::milliseconds(500));
  }
  return static_cast<int>(ExitCode::done);
}

}  // namespace

Action add_log(CLI::App& app) {
  auto a = std::make_shared<LogArguments>();
  app.add_option("JOB", a->job, "the first digits of the job's hash")->required();
  add_database(app, a->database);
  app.add_flag("-f,--follow", a->follow, "go on printing until the job is over");
  return [a] { return log(*a); };
}

}  // namespace eerie::cli
