#include "campaign/auto_fidelity/auto_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/auto_fidelity/auto_map.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/sweeps/job.hpp"
#include "db/jobs/control.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/file.hpp"

namespace eerie::auto_fidelity {
namespace fs = std::filesystem;
using text::Column, text::Field, text::shown, text::Value;

namespace {

/// Those of the next runs that the budget still pays for.
std::vector<Wanted> affordable_next(const AutoFidelity& campaign, double core_hours,
                                    const db::Connection& connection) {
  if (core_hours == 0) return campaign.next();
  return manager::affordable(campaign.next(), core_hours - spent_core_hours(campaign),
                             manager::known_speed(connection));
}

/// A field of what is known of an impact; of one that never ran "-".
Field<AutoCell> known(Column column, std::function<Value(const AutoCell&)> value) {
  return {std::move(column),
          [value](const AutoCell& c) { return !c.is_known() ? Value() : value(c); }};
}

}  // namespace

manager::Tally run_auto(db::Connection& connection, AutoFidelity& campaign, const AutoPlan& plan,
                        const manager::Workplace& workplace, AutoObserver& observer) {
  manager::Tally last;
  for (int round = 1; process::stop_requests() == 0; ++round) {
    campaign.update(connection);
    const std::vector<Wanted> wanted = affordable_next(campaign, plan.core_hours, connection);
    if (wanted.empty()) break;
    std::vector<Scene> scenes;
    for (const Wanted& run : wanted) scenes.push_back(run.scene);
    const db::AddedSweep added = manager::add_when_free(connection, observer, [&] {
      const db::AddedSweep sweep =
          db::add_sweep(connection, plan.name, plan.document, sweeps::identify(scenes));
      if (plan.retry_failed && round == 1) db::retry_failed(connection, sweep.sweep);
      return sweep;
    });
    last = manager::tally(connection, added.sweep);
    if (last.left == 0) break;  // what is wanted has failed before
    AutoRound begun{round, std::vector<std::size_t>(campaign.rungs().size()), last.left};
    for (const Wanted& run : wanted) ++begun.wanted[run.rung];
    observer.begins(begun, campaign);
    manager::work(connection, added.sweep, workplace, observer);
    last = manager::tally(connection, added.sweep);
    if (last.left > 0) break;  // stopped, or paused
  }
  campaign.update(connection);
  return last;
}

bool is_budget_spent(const AutoFidelity& campaign, const AutoPlan& plan,
                     const db::Connection& connection) {
  return plan.core_hours > 0 && !campaign.next().empty() &&
         affordable_next(campaign, plan.core_hours, connection).empty();
}

text::Table table_of_cells(const AutoFidelity& campaign) {
  const auto scene = [](const char* header, double (*value)(const Scene&)) {
    return Field<AutoCell>{shown(header),
                           [value](const AutoCell& c) { return value(c.scenes.front()); }};
  };
  return text::table_of<AutoCell>(
      {scene("q", [](const Scene& s) { return s.impact.q; }),
       scene("phi_d deg", [](const Scene& s) { return s.material.drucker_prager.phi_d_deg; }),
       scene("v cm/s", [](const Scene& s) { return s.impact.v_imp_cm_per_s; }),
       scene("theta deg", [](const Scene& s) { return s.impact.theta_imp_deg; }),
       known(shown("rests on"),
             [&](const AutoCell& c) {
               return fmt::format("{} x {}", campaign.fidelity(c), c.seeds());
             }),
       known(shown("class"), [](const AutoCell& c) { return c.verdict.outcome; }),
       known(shown("P(class)", "{:.2f}"), [](const AutoCell& c) { return c.verdict.p_outcome; }),
       known(shown("b/a", "{:.3f}"), [](const AutoCell& c) { return c.verdict.b_over_a; }),
       known(shown("P(b/a < 0.3)", "{:.2f}"),
             [](const AutoCell& c) { return c.verdict.p_elongated; }),
       {shown(""),
        [&](const AutoCell& c) {
          return !c.is_known() ? "not run" : campaign.in_doubt(c) ? "in doubt" : "";
        }}},
      campaign.cells());
}

double spent_core_hours(const AutoFidelity& campaign) {
  double sum = 0;
  for (const double seconds : campaign.core_seconds()) sum += seconds;
  return sum / 3600;
}

std::string hours_by_rung(const AutoFidelity& campaign) {
  std::string text;
  const std::vector<double> spent = campaign.core_seconds();
  for (std::size_t r = 0; r < spent.size(); ++r)
    if (spent[r] > 0)
      text += fmt::format("{}{:.2f} {}", text.empty() ? "" : ", ", spent[r] / 3600,
                          campaign.rungs()[r].name);
  return text;
}

nlohmann::json core_seconds_by_rung(const AutoFidelity& campaign) {
  nlohmann::json seconds = nlohmann::json::object();
  const std::vector<double> spent = campaign.core_seconds();
  for (std::size_t r = 0; r < spent.size(); ++r)
    if (spent[r] > 0) seconds[campaign.rungs()[r].name] = spent[r];
  return seconds;
}

std::size_t doubtful(const AutoFidelity& campaign) {
  return static_cast<std::size_t>(std::ranges::count_if(
      campaign.cells(), [&](const AutoCell& cell) { return campaign.in_doubt(cell); }));
}

std::vector<fs::path> write_results(const AutoFidelity& campaign, const fs::path& stem) {
  std::vector<fs::path> files = {stem.string() + ".csv"};
  install_text(files[0], auto_csv(campaign));
  const std::vector<diagrams::PhaseDiagram> diagrams = phase_diagrams(campaign);
  for (const diagrams::PhaseDiagram& diagram : diagrams)
    for (const char* end : {".png", ".svg"}) {
      const std::string which =
          diagrams.size() > 1 ? fmt::format("-q{}-phi{}", diagram.q, diagram.phi_d_deg) : "";
      files.push_back(stem.string() + which + end);
      diagrams::draw_phase_diagram(files.back(), diagram);
    }
  return files;
}

}  // namespace eerie::auto_fidelity
