#include <algorithm>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/overview/advice.hpp"
#include "campaign/overview/estimate.hpp"
#include "campaign/process/cores.hpp"
#include "campaign/sweeps/fidelity.hpp"
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

/// Which settings? For the impacts of this sweep, on this machine.
void say_advice(Answer& answer, const overview::Advice& advice) {
  constexpr double night_h = 8;
  const std::size_t cores = process::usable_cores();
  Table table = overview::table_of(advice);
  answer.data["advice"] = {{"impacts", advice.impacts},
                           {"fidelities", records(table)},
                           {"auto",
                            {{"core_hours_least", advice.auto_least_core_hours},
                             {"core_hours_most", advice.auto_most_core_hours}}}};
  answer.say("\nWhich settings? For {} impact{}, with as many seeds as the question needs:\n\n",
             advice.impacts, advice.impacts == 1 ? "" : "s");
  answer.add(std::move(table));
  answer.say(
      "auto: {:.3g} core-hours for two coarse runs of each; finer runs and more seeds where in "
      "doubt, "
      "{:.3g} at most\n",
      advice.auto_least_core_hours, advice.auto_most_core_hours);
  if (const auto best = overview::finest_within(advice, night_h, cores))
    answer.say("A night ({:g} h, {} core{}) is enough for --fidelity {} with {} seed{}.\n", night_h,
               cores, cores == 1 ? "" : "s", best->fidelity, best->seeds,
               best->seeds == 1 ? "" : "s");
  else
    answer.say("A night ({:g} h, {} core{}) is too short for all of them.\n", night_h, cores,
               cores == 1 ? "" : "s");
}

/// `auto` begins with sketches, or with the first rung whose impactors have particles enough.
sweeps::Plan first_plan(const fs::path& sweep, SceneChanges changes) {
  if (changes.fidelity != "auto") return sweeps::load_plan(sweep, changes);
  for (std::string_view rung = sweeps::fidelities[0].name;; rung = sweeps::rung_above(rung)) {
    changes.fidelity = rung;
    try {
      return sweeps::load_plan(sweep, changes);
    } catch (const TooFewParticles&) {
      if (sweeps::rung_above(rung).empty()) throw;
    }
  }
}

Answer expand(const ExpandArguments& a) {
  const sweeps::Plan plan = first_plan(a.sweep, a.changes);
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
  // A remnant has the particles that it has.
  if (plan.scenes.front().target.remnant.file.empty())
    say_advice(answer, overview::advice(plan.scenes, e.speed));
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
