#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "campaign/auto_fidelity/auto_fidelity.hpp"
#include "campaign/auto_fidelity/auto_map.hpp"
#include "campaign/cli/commands.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/cli/work.hpp"
#include "campaign/manager/throughput.hpp"
#include "campaign/maps/map.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/studies/convergence_study.hpp"
#include "campaign/sweeps/job.hpp"
#include "db/jobs/control.hpp"
#include "db/jobs/jobs.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

sweeps::Sweep sweep_with(const RunArguments& a, const char* fidelity) {
  return sweeps::load_sweep(a.sweep, SceneChanges{a.changes.overrides, fidelity}.all());
}

auto_fidelity::AutoOptions options_of(const RunArguments& a) {
  auto_fidelity::AutoOptions options;
  if (a.confidence > 0) options.confidence = a.confidence;
  if (a.most_seeds > 0) options.most_seeds = a.most_seeds;
  return options;
}

double spent_core_hours(const auto_fidelity::AutoFidelity& campaign) {
  double sum = 0;
  for (const auto& [fidelity, seconds] : campaign.core_seconds()) sum += seconds;
  return sum / 3600;
}

/// Those of the next runs that the budget still pays for.
std::vector<auto_fidelity::Wanted> affordable_next(const auto_fidelity::AutoFidelity& campaign,
                                                   const RunArguments& a,
                                                   const db::Connection& connection) {
  if (a.core_hours == 0) return campaign.next();
  const db::Speed speed = db::speed(connection);
  return studies::affordable(campaign.next(), a.core_hours - spent_core_hours(campaign),
                             speed.is_measured() ? speed : manager::assumed_speed);
}

std::size_t doubtful(const auto_fidelity::AutoFidelity& campaign) {
  return static_cast<std::size_t>(std::ranges::count_if(
      campaign.cells(),
      [&](const auto_fidelity::AutoCell& cell) { return campaign.in_doubt(cell); }));
}

std::string table_of(const auto_fidelity::AutoFidelity& campaign) {
  std::vector<std::vector<std::string>> rows = {{"q", "phi_d deg", "v cm/s", "theta deg",
                                                 "rests on", "class", "P(class)", "b/a",
                                                 "P(b/a < 0.3)", ""}};
  for (const auto_fidelity::AutoCell& c : campaign.cells()) {
    const Scene& s = c.survey_scene;
    std::vector<std::string> row = {
        fmt::format("{}", s.impact.q), fmt::format("{}", s.material.drucker_prager.phi_d_deg),
        fmt::format("{}", s.impact.v_imp_cm_per_s), fmt::format("{}", s.impact.theta_imp_deg)};
    if (c.fidelity.empty())
      row.insert(row.end(), {"-", "-", "-", "-", "-", "not run"});
    else
      row.insert(
          row.end(),
          {fmt::format("{} x {}", c.fidelity, c.seeds()), c.verdict.outcome,
           fmt::format("{:.2f}", c.verdict.p_outcome), fmt::format("{:.3f}", c.verdict.b_over_a),
           fmt::format("{:.2f}", c.verdict.p_elongated), campaign.in_doubt(c) ? "in doubt" : ""});
    rows.push_back(std::move(row));
  }
  return text_table(rows);
}

/// The numbers and one map per mass ratio and friction angle, beside the database.
std::vector<fs::path> write_all(const auto_fidelity::AutoFidelity& campaign, const RunArguments& a,
                                const std::string& name) {
  const fs::path stem =
      a.database.parent_path() / fmt::format("{}-{}-auto", a.database.stem().string(), name);
  std::vector<fs::path> files = {stem.string() + ".csv"};
  install_text(files[0], auto_fidelity::auto_csv(campaign));
  const std::vector<diagrams::PhaseDiagram> diagrams = auto_fidelity::phase_diagrams(campaign);
  for (const diagrams::PhaseDiagram& diagram : diagrams)
    for (const char* end : {".png", ".svg"}) {
      const std::string which =
          diagrams.size() > 1 ? fmt::format("-q{}-phi{}", diagram.q, diagram.phi_d_deg) : "";
      files.push_back(stem.string() + which + end);
      diagrams::draw_phase_diagram(files.back(), diagram);
    }
  return files;
}

void print_round(int round, const auto_fidelity::AutoFidelity& campaign,
                 const std::vector<auto_fidelity::Wanted>& wanted, std::size_t left) {
  const auto surveys =
      static_cast<std::size_t>(std::ranges::count(wanted, true, &auto_fidelity::Wanted::survey));
  fmt::print(
      "round {}: {} of {} impacts in doubt; {} sketches and {} surveys wanted, {} to run; {:.2f} "
      "core-hours so far\n",
      round, doubtful(campaign), campaign.cells().size(), wanted.size() - surveys, surveys, left,
      spent_core_hours(campaign));
  std::fflush(stdout);
}

}  // namespace

int run_auto(const RunArguments& a) {
  if (!a.maps.empty())
    throw InputError("--map: --fidelity auto draws its own maps beside the database; leave it out");
  const sweeps::Sweep sweep = sweep_with(a, "survey");
  auto_fidelity::AutoFidelity campaign(sweep_with(a, "sketch"), sweep, options_of(a));
  require_consistent(a.engine);
  process::catch_stop_signals();
  process::hold_signals();
  make_folder_of(a.database);
  const db::Lock lock(a.database);
  db::Connection connection(a.database, db::Access::write);
  if (!a.engine.jobs_dir.empty()) job_folder::choose_job_folder(connection, a.engine.jobs_dir);
  const std::string name = sweep.name + "-auto";
  Tally last;
  for (int round = 1; process::stop_requests() == 0; ++round) {
    campaign.update(connection);
    const std::vector<auto_fidelity::Wanted> wanted = affordable_next(campaign, a, connection);
    if (wanted.empty()) break;
    std::vector<Scene> scenes;
    for (const auto_fidelity::Wanted& run : wanted) scenes.push_back(run.scene);
    const db::AddedSweep added =
        db::add_sweep(connection, name, sweeps::document(sweep), sweeps::identify(scenes));
    if (a.retry_failed && round == 1) db::retry_failed(connection, added.sweep);
    last = tally(connection, added.sweep);
    if (last.left == 0) break;  // what is wanted has failed before
    if (!a.json) print_round(round, campaign, wanted, last.left);
    work(connection, {a.workers, a.threads_per_job, a.json}, added.sweep, a.engine);
    last = tally(connection, added.sweep);
    if (last.left > 0) break;  // stopped, or paused
  }
  campaign.update(connection);
  const std::vector<fs::path> files = write_all(campaign, a, sweep.name);
  const std::size_t doubts = doubtful(campaign);
  if (a.json) {
    json paths = json::array();
    for (const fs::path& file : files) paths.push_back(file.string());
    fmt::print("{}\n", json{{"sweep", name},
                            {"impacts", campaign.cells().size()},
                            {"in_doubt", doubts},
                            {"core_seconds", campaign.core_seconds()},
                            {"failed", last.failed},
                            {"left", last.left},
                            {"files", std::move(paths)}}
                           .dump(1));
  } else {
    fmt::print("\n{}\n{} impacts, {} in doubt; {:.2f} core-hours", table_of(campaign),
               campaign.cells().size(), doubts, spent_core_hours(campaign));
    if (const double uniform = campaign.uniform_core_seconds() / 3600; uniform > 0)
      fmt::print(" (about {:.2f} for as many surveys of every impact as of the most doubtful)",
                 uniform);
    if (last.failed > 0) fmt::print("; {} runs failed (eerie status says why)", last.failed);
    fmt::print("\n");
    for (const fs::path& file : files) fmt::print("{}\n", file.string());
  }
  if (last.left > 0) {
    fmt::print(stderr, "stopped; the same command goes on\n");
    return stopped_by_signal;
  }
  return static_cast<int>(last.failed > 0 ? ExitCode::job_failed : ExitCode::done);
}

}  // namespace eerie::cli
