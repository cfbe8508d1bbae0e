#include <fmt/format.h>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/manager/inbox.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/sweeps/plan.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "db/store/connection.hpp"
#include "solver/base/error.hpp"

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
void require_database(const fs::path& database) { db::Connection(database, db::Access::read); }

struct ChangeArguments {
  fs::path database;
  SelectionArguments selection;
  std::string value;
  bool stale = false, json = false;
};

/// Sends a request about selected jobs and says how many it changed.
int change(const ChangeArguments& a, manager::Request request, const char* done) {
  request.selection =
      selection_of(a.selection, request.kind == "rerun-stale" ? "retry" : request.kind);
  require_database(a.database);
  const auto answer = ask(a.database, request);
  if (a.json) {
    fmt::print("{}\n", answer ? answer->dump(1) : json{{"jobs", nullptr}}.dump(1));
  } else if (!answer) {
    fmt::print("the manager at work is busy; it will do it\n");
  } else {
    const auto jobs = answer->at("jobs").get<std::size_t>();
    fmt::print("{} job{} {}\n", jobs, jobs == 1 ? "" : "s", done);
    if (jobs == 0)
      fmt::print(stderr,
                 "nothing to do: no job that this concerns matches; `eerie status --db {}` "
                 "shows what there is\n",
                 a.database.string());
  }
  return static_cast<int>(ExitCode::done);
}

std::shared_ptr<ChangeArguments> add_change(CLI::App& app) {
  auto a = std::make_shared<ChangeArguments>();
  add_database(app, a->database);
  add_selection(app, a->selection);
  add_json(app, a->json);
  return a;
}

struct SubmitArguments {
  fs::path sweep, database;
  SceneChanges changes;
  std::optional<int> priority;
  std::string wall_limit;
  bool json = false;
};

int submit(const SubmitArguments& a) {
  manager::Request request;
  request.kind = "submit";
  // Mistakes are told here and now.
  const sweeps::Plan plan = sweeps::load_plan(a.sweep, a.changes.all());
  request.sweep = sweeps::document(plan.sweep);
  request.priority = a.priority;
  if (!a.wall_limit.empty()) request.wall_limit_s = parse_duration(a.wall_limit, "--wall-limit");
  make_folder_of(a.database);
  const auto answer = ask(a.database, request);
  if (a.json) {
    fmt::print("{}\n", answer ? answer->dump(1) : json{{"sweep", plan.sweep.name}}.dump(1));
    return static_cast<int>(ExitCode::done);
  }
  print_warnings(sweeps::cautions(plan.scenes));
  if (answer)
    fmt::print("{}: {} jobs, {} new\n", plan.sweep.name, answer->at("jobs").get<std::size_t>(),
               answer->at("added").get<std::size_t>());
  else
    fmt::print("{}: the manager at work is busy; it will take it\n", plan.sweep.name);
  return static_cast<int>(ExitCode::done);
}

}  // namespace

Action add_submit(CLI::App& app) {
  auto a = std::make_shared<SubmitArguments>();
  app.add_option("SWEEP", a->sweep, "sweep file")->required();
  add_database(app, a->database);
  add_changes(app, a->changes);
  app.add_option("--priority", a->priority, "of its new jobs; higher ones come first (default: 0)");
  app.add_option("--wall-limit", a->wall_limit, "wall time of each new job at most, such as 2h");
  add_json(app, a->json);
  return [a] { return submit(*a); };
}

Action add_pause(CLI::App& app) {
  return [a = add_change(app)] { return change(*a, {.kind = "pause"}, "paused"); };
}

Action add_resume(CLI::App& app) {
  return [a = add_change(app)] { return change(*a, {.kind = "resume"}, "resumed"); };
}

Action add_cancel(CLI::App& app) {
  return [a = add_change(app)] { return change(*a, {.kind = "cancel"}, "cancelled"); };
}

Action add_retry(CLI::App& app) {
  auto a = add_change(app);
  app.add_flag("--stale", a->stale,
               "jobs whose result an other solver version made, in place of failed and cancelled");
  return [a] {
    return a->stale ? change(*a, {.kind = "rerun-stale"}, "will run again")
                    : change(*a, {.kind = "retry"}, "will be tried again");
  };
}

Action add_priority(CLI::App& app) {
  auto a = std::make_shared<ChangeArguments>();
  auto priority = std::make_shared<int>(0);
  app.add_option("PRIORITY", *priority, "higher ones come first; 0 is usual")->required();
  add_database(app, a->database);
  add_selection(app, a->selection);
  add_json(app, a->json);
  return
      [a, priority] { return change(*a, {.kind = "priority", .priority = *priority}, "changed"); };
}

Action add_wall_limit(CLI::App& app) {
  auto a = std::make_shared<ChangeArguments>();
  app.add_option("LIMIT", a->value, "wall time of each job at most, such as 2h; or none")
      ->required();
  add_database(app, a->database);
  add_selection(app, a->selection);
  add_json(app, a->json);
  return [a] {
    manager::Request request{.kind = "wall-limit"};
    if (a->value != "none") request.wall_limit_s = parse_duration(a->value, "LIMIT");
    return change(*a, request, "changed");
  };
}

}  // namespace eerie::cli
