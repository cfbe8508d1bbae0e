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

namespace eerie::manager {
using nlohmann::json;

namespace {

struct LaterJob {
  std::int64_t job = 0;  ///< that it goes on with
  db::NewJob later;
};

/// Makes the directory of the job that goes on; throws InputError where it cannot.
LaterJob prepared(const db::Connection& connection, const db::Job& job, double until_s,
                  json& extended) {
  if (job.state != db::JobState::done)
    throw InputError("it has no result yet; extend it once it is done");
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
  std::ranges::sort(jobs, std::greater(), &db::Job::id);
  for (const db::Job& job : jobs) try {
      later.push_back(prepared(connection, job, request.until_s.value(), extended));
    } catch (const InputError& error) {
      refused.push_back({{"job", job.hash}, {"reason", error.what()}});
    }
  if (later.empty() && !refused.empty())
    throw InputError(fmt::format("{}: {}", refused[0].at("job").get<std::string>().substr(0, 16),
                                 refused[0].at("reason").get<std::string>()));
  return json::parse(db::once(connection, request.id, request.kind, [&](SQLite::Database& sql) {
    for (const LaterJob& one : later) db::add_extension(sql, one.job, one.later);
    return json{{"jobs", later.size()}, {"extended", extended}, {"refused", refused}}.dump();
  }));
}

}  // namespace eerie::manager
