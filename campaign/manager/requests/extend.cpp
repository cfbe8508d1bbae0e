#include "campaign/manager/requests/extend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "campaign/job_folder/extension.hpp"
#include "campaign/sweeps/job.hpp"
#include "db/jobs/control.hpp"
#include "db/jobs/extension.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::manager {
using nlohmann::json;

namespace {

struct LaterJob {
  std::int64_t job = 0;  ///< that it goes on with
  db::NewJob later;
};

/// Why a job without a result cannot go on, and what to type.
std::string without_end(const db::Connection& connection, const db::Job& job) {
  const std::string database = " --db " + shell_word(connection.path().string());
  const std::string name = job.hash.substr(0, 8);
  switch (job.state) {
    case db::JobState::failed:
      return fmt::format(
          "it has failed; `eerie show {0}{1}` says why, `eerie retry {0}{1}` has it "
          "tried again; extend it once it is done",
          name, database);
    case db::JobState::cancelled:
      return fmt::format(
          "it was cancelled; `eerie retry {}{}` takes that back; extend it once it is "
          "done",
          name, database);
    case db::JobState::running:
      return "it is running and has no end yet to go on from; extend it once it is done";
    default:
      return fmt::format(
          "it is pending and has no end yet to go on from; `eerie daemon{} "
          "--until-idle` runs it; extend it once it is done",
          database);
  }
}

/// Makes the directory of the job that goes on; throws InputError where it cannot.
LaterJob prepared(const db::Connection& connection, const db::Job& job, double until_s,
                  json& extended) {
  if (job.state != db::JobState::done) throw InputError(without_end(connection, job));
  const job_folder::JobFolder folder = job_folder::job_folder(connection);
  const job_folder::JobDirectory finished = folder.of(job.hash);
  const Scene scene = parse_scene(json::parse(db::scene(connection, job.id)));
  const Scene later = job_folder::extended_scene(finished, scene, until_s);
  LaterJob made{job.id, sweeps::new_job(later)};
  made.later.priority = job.priority;
  const double from_s = job_folder::make_extension(finished, folder.of(made.later.hash), later);
  extended.push_back({{"job", job.hash}, {"as", made.later.hash}, {"from_s", from_s}});
  return made;
}

}  // namespace

json extend(db::Connection& connection, const Request& request) {
  std::vector<LaterJob> later;
  json extended = json::array(), refused = json::array();
  // Of several with one impact the one that was extended last is the furthest.
  std::vector<db::Job> jobs = db::jobs(connection, {.selection = request.selection});
  if (jobs.empty())
    throw InputError(
        fmt::format("no job of {0} is meant; `eerie query --db {1} --columns hash` "
                    "shows those that can go on",
                    connection.path().string(), shell_word(connection.path().string())));
  std::ranges::sort(jobs, std::greater(), &db::Job::id);
  for (const db::Job& job : jobs) try {
      later.push_back(prepared(connection, job, request.until_s.value(), extended));
    } catch (const InputError& error) {
      refused.push_back({{"job", job.hash}, {"reason", error.what()}});
    }
  if (later.empty() && !refused.empty())
    throw InputError(fmt::format("job {}: {}",
                                 refused[0].at("job").get<std::string>().substr(0, 16),
                                 refused[0].at("reason").get<std::string>()));
  return json::parse(db::once(connection, request.id, request.kind, [&](SQLite::Database& sql) {
    for (const LaterJob& one : later) db::add_extension(sql, one.job, one.later);
    return json{{"jobs", later.size()}, {"extended", extended}, {"refused", refused}}.dump();
  }));
}

}  // namespace eerie::manager
