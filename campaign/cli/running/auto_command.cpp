#include "campaign/cli/output/campaign_watch.hpp"
#include "campaign/cli/running/run_arguments.hpp"
#include "campaign/results/results_table.hpp"
#include "campaign/text/given_file.hpp"
#include "campaign/text/json_file.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::cli {
using auto_fidelity::AutoFidelity;

namespace {

Answer answer_of(const RunArguments& a, const AutoFidelity& campaign, const std::string& sweep,
                 const manager::Tally& last, const std::vector<std::filesystem::path>& files) {
  Answer answer;
  conclude(answer, last, a.database);
  const std::size_t doubts = auto_fidelity::doubtful(campaign), all = campaign.cells().size();
  answer.data = {
      {"sweep", sweep},          {"impacts", all},
      {"in_doubt", doubts},      {"core_seconds", auto_fidelity::core_seconds_by_rung(campaign)},
      {"failed", last.failed},   {"left", last.left},
      {"files", names_of(files)}};
  answer.say("\n");
  answer.add(auto_fidelity::table_of_cells(campaign));
  const double uniform = campaign.uniform_core_seconds() / 3600;
  answer.say("\n{} impacts, {} in doubt; {:.2f} core-hours: {}{}{}\n", all, doubts,
             auto_fidelity::spent_core_hours(campaign), auto_fidelity::hours_by_rung(campaign),
             uniform > 0 ? fmt::format(" (about {:.2f} for every impact as finely and often as "
                                       "the most doubtful)",
                                       uniform)
                         : "",
             last.failed > 0 ? fmt::format("; {} runs failed (`eerie status --db {}` says why)",
                                           last.failed, shell_word(a.database.string()))
                             : "");
  answer.add_files(files);
  return answer;
}

std::string budget(double core_hours) {
  return core_hours > 0 ? fmt::format("--budget {:g}", core_hours) : "";
}

}  // namespace

Answer run_auto(const RunArguments& a, Output& out) {
  if (!a.maps.empty())
    throw InputError("--map: --fidelity auto draws its own maps beside the database; leave it out");
  const std::string where = text::given_name(a.sweep);
  const nlohmann::json document = text::load_given_json(a.sweep);
  AutoFidelity campaign(auto_fidelity::ladder(document, a.changes.overrides, where, a.finest),
                        a.automatic);
  print_warnings(a.changes.replaced(document.value("scene", nlohmann::json::object()), where));
  const sweeps::Sweep& sweep = campaign.rungs().back().sweep;
  require_consistent(a.scheduler);
  HeldDatabase held(a.database, a.scheduler);
  const auto_fidelity::AutoPlan plan{sweep.name + "-auto", sweeps::document(sweep), a.core_hours,
                                     a.retry_failed};
  manager::Tally last;
  {
    CampaignWatch watch(plan.name, out);
    last = auto_fidelity::run_auto(held.connection, campaign, plan, workplace(a.scheduler, a.share),
                                   watch);
  }
  if (const std::string drift = results::drift_warning(held.connection, plan.name); !drift.empty())
    print_warnings({drift});
  const std::string stem = fmt::format("{}-{}-auto", a.database.stem().string(), sweep.name);
  Answer answer =
      answer_of(a, campaign, plan.name, last,
                auto_fidelity::write_results(campaign, a.database.parent_path() / stem));
  std::vector<overview::NextStep> steps;
  if (last.left > 0)
    steps.push_back({"go on", overview::command_of(typed(a), budget(a.core_hours))});
  else if (auto_fidelity::is_budget_spent(campaign, plan, held.connection)) {
    answer.say("stopped: what is wanted next would exceed the budget of {:g} core-hours\n",
               a.core_hours);
    steps.push_back({"go on with twice the budget, what is done included",
                     overview::command_of(typed(a), budget(2 * a.core_hours))});
  }
  std::erase_if(steps, [](const overview::NextStep& step) { return step.command.empty(); });
  answer.data["next"] = overview::to_json(steps);
  answer.add_text(overview::text_of(steps));
  return answer;
}

}  // namespace eerie::cli
