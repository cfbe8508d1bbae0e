#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "campaign/cli/commands.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/cli/output/campaign_watch.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/process/signals.hpp"
#include "db/store/lock.hpp"
#include "solver/base/error.hpp"

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
  const auto_fidelity::AutoPlan plan{sweep.name + "-auto", sweeps::document(sweep), a.core_hours,
                                     a.retry_failed};
  CampaignWatch watch(plan.name, a.json);
  const manager::Tally last =
      auto_fidelity::run_auto(connection, campaign, plan,
                              workplace(a.engine, {a.workers, a.threads_per_job}), watch);
  watch.finish();
  const std::vector<fs::path> files = auto_fidelity::write_results(
      campaign,
      a.database.parent_path() / fmt::format("{}-{}-auto", a.database.stem().string(), sweep.name));
  const std::size_t doubts = auto_fidelity::doubtful(campaign);
  if (a.json) {
    json paths = json::array();
    for (const fs::path& file : files) paths.push_back(file.string());
    fmt::print("{}\n", json{{"sweep", plan.name},
                            {"impacts", campaign.cells().size()},
                            {"in_doubt", doubts},
                            {"core_seconds", campaign.core_seconds()},
                            {"failed", last.failed},
                            {"left", last.left},
                            {"files", std::move(paths)}}
                           .dump(1));
  } else {
    fmt::print("\n{}\n{} impacts, {} in doubt; {:.2f} core-hours", table_of(campaign),
               campaign.cells().size(), doubts, auto_fidelity::spent_core_hours(campaign));
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
