#include <map>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/manager/inbox.hpp"
#include "campaign/queries/numbers.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/sweeps/plan.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "db/store/connection.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Long enough for a daemon that expands a hundred thousand jobs.
constexpr auto patience = std::chrono::seconds(30);

/// Has the request carried out; nothing where the answer is still to come. Throws what it says
/// against the input.
std::optional<json> ask(const fs::path& database, manager::Request request) {
  request.id = manager::new_request_id();
  const auto answer = manager::send(database, request, patience);
  if (answer && answer->contains("error")) throw InputError(answer->at("error").get<std::string>());
  return answer;
}

/// A database that is not there is a slip of the hand: only `submit` makes one.
void require_database(const fs::path& database) { db::Connection(database, db::Access::read_any); }

struct ChangeArguments {
  fs::path database;
  queries::JobChoice selection;
};

/// Has a request about selected jobs carried out, and puts what it did into `answer`. Nothing, and
/// a line that says so, where the manager is busy.
std::optional<json> ask_about_jobs(const ChangeArguments& a, manager::Request request,
                                   Answer& answer) {
  request.selection =
      queries::selection_of(a.selection, request.kind == "rerun-stale" ? "retry" : request.kind);
  require_database(a.database);
  const auto told = ask(a.database, request);
  answer.data = told.value_or(json{{"jobs", nullptr}});
  if (!told) answer.say("the manager at work is busy; it will do it\n");
  return told;
}

/// Sends a request about selected jobs and says how many it changed.
Answer change(const ChangeArguments& a, const manager::Request& request, const char* done) {
  Answer answer;
  const auto told = ask_about_jobs(a, request, answer);
  if (!told) return answer;
  const auto jobs = told->at("jobs").get<std::size_t>();
  answer.say("{} {}\n", count_of(jobs, "job"), done);
  if (jobs == 0)
    answer.warn(
        fmt::format("nothing to do: no job that this concerns matches; `eerie status --db "
                    "{}` shows what there is",
                    shell_word(a.database.string())));
  return answer;
}

std::shared_ptr<ChangeArguments> add_change(CLI::App& app) {
  auto a = std::make_shared<ChangeArguments>();
  add_database(app, a->database);
  add_selection(app, a->selection);
  add_formats(app);
  return a;
}

/// What was refused, by the reason, with an example each.
void add_refused(Answer& answer, const json& refused) {
  std::map<std::string, std::vector<std::string>> by_reason;
  for (const json& one : refused)
    by_reason[one.at("reason").get<std::string>()].push_back(one.at("job").get<std::string>());
  for (const auto& [reason, jobs] : by_reason)
    answer.warn(fmt::format("{} not extended ({}{}): {}", count_of(jobs.size(), "job"),
                            jobs.front().substr(0, 8), jobs.size() > 1 ? ", ..." : "", reason));
}

Answer extend(const ChangeArguments& a, double until_s) {
  if (!(until_s > 0))
    throw InputError(
        fmt::format("--until = {:g}: must be a simulated time above 0 s, later than "
                    "the end of the jobs; for example 60000",
                    until_s));
  Answer answer;
  const auto told = ask_about_jobs(a, {.kind = "extend", .until_s = until_s}, answer);
  if (!told) return answer;
  answer.say("{} to {:.12g} s\n",
             count_of(told->at("jobs").get<std::size_t>(), "job") + " will go on", until_s);
  for (const json& job : told->at("extended"))
    answer.say("  {} goes on as {} from {:.0f} s\n", job.at("job").get<std::string>().substr(0, 16),
               job.at("as").get<std::string>().substr(0, 16), job.at("from_s").get<double>());
  answer.say("a daemon at work runs them, or `eerie daemon --db {} --until-idle`\n",
             shell_word(a.database.string()));
  add_refused(answer, told->at("refused"));
  return answer;
}

struct SubmitArguments {
  fs::path sweep, database;
  SceneChanges changes;
  std::optional<int> priority;
  std::string wall_limit;
};

Answer submit(const SubmitArguments& a) {
  manager::Request request;
  request.kind = "submit";
  // Mistakes are told here and now.
  const sweeps::Plan plan = sweeps::load_plan(a.sweep, a.changes);
  request.sweep = sweeps::document(plan.sweep);
  request.priority = a.priority;
  if (!a.wall_limit.empty())
    request.wall_limit_s = queries::parse_duration(a.wall_limit, "--wall-limit");
  make_folder_of_database(a.database);
  const auto told = ask(a.database, request);
  Answer answer;
  answer.data = told.value_or(json{{"sweep", plan.sweep.name}});
  for (const std::string& warning : plan.replaced) answer.warn(warning);
  for (const std::string& warning : sweeps::cautions(plan.scenes)) answer.warn(warning);
  if (told)
    answer.say("{}: {} jobs, {} new\n", told->at("sweep").get<std::string>(),
               told->at("jobs").get<std::size_t>(), told->at("added").get<std::size_t>());
  else
    answer.say("{}: the manager at work is busy; it will take it\n", plan.sweep.name);
  return answer;
}

}  // namespace

Action add_submit(CLI::App& app) {
  auto a = std::make_shared<SubmitArguments>();
  app.add_option("SWEEP", a->sweep, "sweep file")->required();
  add_database(app, a->database);
  add_changes(app, a->changes);
  app.add_option("--priority", a->priority,
                 "of its jobs that were never tried; higher ones come first (default: 0)");
  app.add_option("--wall-limit", a->wall_limit, "wall time at most of each of them, such as 2h");
  add_formats(app);
  return [a](Output&) { return submit(*a); };
}

Action add_pause(CLI::App& app) {
  return [a = add_change(app)](Output&) { return change(*a, {.kind = "pause"}, "paused"); };
}

Action add_resume(CLI::App& app) {
  return [a = add_change(app)](Output&) { return change(*a, {.kind = "resume"}, "resumed"); };
}

Action add_cancel(CLI::App& app) {
  return [a = add_change(app)](Output&) { return change(*a, {.kind = "cancel"}, "cancelled"); };
}

Action add_extend(CLI::App& app) {
  auto a = add_change(app);
  auto until = std::make_shared<double>(0);
  app.add_option("--until", *until,
                 "the later end, simulated time, s; jobs that are not done are refused")
      ->required();
  return [a, until](Output&) { return extend(*a, *until); };
}

Action add_retry(CLI::App& app) {
  auto a = add_change(app);
  auto stale = std::make_shared<bool>(false);
  app.add_flag("--stale", *stale,
               "jobs whose result an other solver version made, in place of failed and cancelled");
  return [a, stale](Output&) {
    return *stale ? change(*a, {.kind = "rerun-stale"}, "will run again")
                  : change(*a, {.kind = "retry"}, "will be tried again");
  };
}

Action add_priority(CLI::App& app) {
  auto priority = std::make_shared<int>(0);
  app.add_option("PRIORITY", *priority, "higher ones come first; 0 is usual")->required();
  auto a = add_change(app);
  return [a, priority](Output&) {
    return change(*a, {.kind = "priority", .priority = *priority}, "changed");
  };
}

Action add_wall_limit(CLI::App& app) {
  auto limit = std::make_shared<std::string>();
  app.add_option("LIMIT", *limit, "wall time of each job at most, such as 2h; or none")->required();
  auto a = add_change(app);
  return [a, limit](Output&) {
    manager::Request request{.kind = "wall-limit"};
    if (*limit != "none") request.wall_limit_s = queries::parse_duration(*limit, "LIMIT");
    return change(*a, request, "changed");
  };
}

}  // namespace eerie::cli
