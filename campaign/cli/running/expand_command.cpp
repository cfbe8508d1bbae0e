#include <algorithm>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/overview/estimate.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/sweeps/plan.hpp"
#include "db/jobs/jobs.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

struct ExpandArguments {
  fs::path sweep, database;
  SceneChanges changes;
  bool list = false;
};

Answer expand(const ExpandArguments& a) {
  const sweeps::Plan plan = sweeps::load_plan(a.sweep, a.changes);
  const std::vector<db::NewJob>& jobs = plan.jobs;
  std::vector<std::string> warned = plan.replaced;
  std::ranges::move(sweeps::cautions(plan.scenes), std::back_inserter(warned));
  const overview::Estimate e = overview::estimate(a.database, jobs);
  Answer answer;
  answer.data = {{"sweep", plan.sweep.name},
                 {"database", a.database.string()},
                 {"jobs", jobs.size()},
                 {"new", e.unknown},
                 {"core_hours", e.core_hours},
                 {"particle_steps_per_core_second", e.speed},
                 {"speed_is_measured", e.measured},
                 {"warnings", warned}};
  if (a.list) {
    Table table = overview::table_of_jobs(jobs);
    answer.data["list"] = records(table);
    answer.add(std::move(table));
    answer.say("\n");
  }
  answer.say("{}: {} jobs, {} of them new to {}\n", plan.sweep.name, jobs.size(), e.unknown,
             a.database);
  answer.say(
      "about {:.3g} core-hours for all of them, at {} particle-steps per second and core ({})\n",
      e.core_hours, magnitude(e.speed),
      e.measured ? "as measured in this database" : "assumed: nothing is measured yet");
  for (const std::string& warning : warned) answer.warn(warning);
  return answer;
}

}  // namespace

Action add_expand(CLI::App& app) {
  auto a = std::make_shared<ExpandArguments>();
  app.add_option("SWEEP", a->sweep, "sweep file")->required();
  add_database(app, a->database);
  add_changes(app, a->changes);
  app.add_flag("--list", a->list, "print every job");
  add_formats(app);
  return [a](Output&) { return expand(*a); };
}

}  // namespace eerie::cli
