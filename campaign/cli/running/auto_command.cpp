#include "campaign/auto_fidelity/auto_fidelity.hpp"
#include "campaign/cli/output/campaign_watch.hpp"
#include "campaign/cli/running/run_arguments.hpp"
#include "campaign/results/results_table.hpp"
#include "campaign/text/given_file.hpp"
#include "campaign/text/json_file.hpp"

namespace eerie::cli {
using auto_fidelity::AutoFidelity;

namespace {

/// `document`: the sweep file's, which may be a pipe and is read once.
sweeps::Sweep sweep_with(const nlohmann::json& document, const RunArguments& a,
                         const char* fidelity) {
  return sweeps::parse_sweep(document, SceneChanges{a.changes.overrides, fidelity}.all(),
                             text::given_name(a.sweep));
}

auto_fidelity::AutoOptions options_of(const RunArguments& a) {
  auto_fidelity::AutoOptions options;
  if (a.confidence > 0) options.confidence = a.confidence;
  if (a.most_seeds > 0) options.most_seeds = a.most_seeds;
  return options;
}

/// Of the results of the sweeps of this name; a changed sweep file makes another one.
std::string drift_warning(const db::Connection& connection, const std::string& name) {
  std::vector<db::ResultRow> all;
  for (const db::SweepStatus& sweep : db::sweep_status(connection)) {
    if (sweep.name != name) continue;
    const std::vector<db::ResultRow> rows = db::results(connection, {.sweep = sweep.id});
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return results::drift_warning(all);
}

Answer answer_of(const AutoFidelity& campaign, const std::string& sweep, const manager::Tally& last,
                 const std::vector<std::filesystem::path>& files) {
  Answer answer;
  conclude(answer, last);
  const std::size_t doubts = auto_fidelity::doubtful(campaign), all = campaign.cells().size();
  answer.data = {{"sweep", sweep},          {"impacts", all},
                 {"in_doubt", doubts},      {"core_seconds", campaign.core_seconds()},
                 {"failed", last.failed},   {"left", last.left},
                 {"files", names_of(files)}};
  answer.say("\n");
  answer.add(auto_fidelity::table_of_cells(campaign));
  const double uniform = campaign.uniform_core_seconds() / 3600;
  answer.say(
      "\n{} impacts, {} in doubt; {:.2f} core-hours{}{}\n", all, doubts,
      auto_fidelity::spent_core_hours(campaign),
      uniform > 0 ? fmt::format(" (about {:.2f} for as many surveys of every impact as of "
                                "the most doubtful)",
                                uniform)
                  : "",
      last.failed > 0 ? fmt::format("; {} runs failed (eerie status says why)", last.failed) : "");
  answer.add_files(files);
  return answer;
}

}  // namespace

Answer run_auto(const RunArguments& a, Output& out) {
  if (!a.maps.empty())
    throw InputError("--map: --fidelity auto draws its own maps beside the database; leave it out");
  const nlohmann::json document = text::load_given_json(a.sweep);
  const sweeps::Sweep sweep = sweep_with(document, a, "survey");
  AutoFidelity campaign(sweep_with(document, a, "sketch"), sweep, options_of(a));
  require_consistent(a.engine);
  HeldDatabase held(a.database, a.engine);
  const auto_fidelity::AutoPlan plan{sweep.name + "-auto", sweeps::document(sweep), a.core_hours,
                                     a.retry_failed};
  manager::Tally last;
  {
    CampaignWatch watch(plan.name, out);
    last = auto_fidelity::run_auto(held.connection, campaign, plan, workplace(a.engine, a.share),
                                   watch);
  }
  if (const std::string drift = drift_warning(held.connection, plan.name); !drift.empty())
    print_warnings({drift});
  const std::string stem = fmt::format("{}-{}-auto", a.database.stem().string(), sweep.name);
  return answer_of(campaign, plan.name, last,
                   auto_fidelity::write_results(campaign, a.database.parent_path() / stem));
}

}  // namespace eerie::cli
