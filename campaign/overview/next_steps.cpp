#include "campaign/overview/next_steps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "campaign/job_folder/extension.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/scene_field.hpp"
#include "campaign/text/given_file.hpp"
#include "campaign/text/plain_text.hpp"
#include "solver/base/text/shell_word.hpp"
#include "solver/scene/field_words.hpp"
#include "solver/scene/tide.hpp"

namespace eerie::overview {
using db::ResultRow;
using nlohmann::json;

namespace {

constexpr const char *speed = "impact.v_imp_cm_per_s", *angle = "impact.theta_imp_deg";

std::string in_database(const TypedRun& run) {
  return " --db " + shell_word(run.database.string());
}

const sweeps::Axis* axis_of(const sweeps::Sweep& sweep, const std::string& path) {
  const auto found = std::ranges::find(sweep.axes, path, &sweeps::Axis::path);
  return found == sweep.axes.end() ? nullptr : &*found;
}

bool varies(const sweeps::Sweep& sweep, const std::string& path) {
  return axis_of(sweep, path) != nullptr ||
         std::ranges::find(sweep.points.paths, path) != sweep.points.paths.end();
}

bool flies(const sweeps::Plan& plan) { return std::ranges::all_of(plan.scenes, may_fly); }

/// When impacts that had not settled by then may have: flight to a meeting takes next to no time to
/// compute, else twice the time. Nothing where that is later than any run may end.
std::optional<double> later_end(const sweeps::Plan& plan, double latest_s) {
  constexpr double time_of_flight_s = 1e6;
  if (flies(plan) && latest_s < time_of_flight_s) return time_of_flight_s;
  const double most = sweeps::scene_field("end.time_s", "").schema->at("maximum").get<double>();
  return 2 * latest_s > most ? std::nullopt : std::optional(2 * latest_s);
}

/// Those that kept a state go on from it, past the latest end of any.
NextStep extended(const TypedRun& run, const sweeps::Plan& plan,
                  const std::vector<ResultRow>& unsettled) {
  double latest_s = 0;
  for (const Scene& scene : plan.scenes)
    latest_s = std::max({latest_s, scene.end.time_s, scene.end.latest_s});
  std::string hashes;
  for (const ResultRow& row : unsettled) hashes += " " + row.hash.substr(0, 8);
  const auto until_s = unsettled.empty() ? std::nullopt : later_end(plan, latest_s);
  if (!until_s) return {};
  return {unsettled.size() == 1
              ? "let the one that has not settled go on from where it was"
              : fmt::format("let the {} that have not settled go on from where they were",
                            unsettled.size()),
          fmt::format("eerie extend{} --until {:.12g}{}", hashes, *until_s, in_database(run))};
}

/// The others need the sweep once more with a later end.
NextStep longer(const TypedRun& run, const sweeps::Plan& plan,
                const std::vector<ResultRow>& unsettled) {
  double latest_s = 0;
  for (const ResultRow& row : unsettled) latest_s = std::max(latest_s, row.end_time_s);
  const bool is_free =
      !varies(plan.sweep, "end.time_s") && !varies(plan.sweep, "end.settled.horizon_s");
  const auto until_s = unsettled.empty() || !is_free ? std::nullopt : later_end(plan, latest_s);
  if (!until_s) return {};
  std::string change = fmt::format("--set end.time_s={:.12g}", *until_s);
  if (flies(plan)) change += fmt::format(" --set end.settled.horizon_s={:.12g}", *until_s);
  return {fmt::format("compute all again to a later end, since {} not settled",
                      unsettled.size() == 1 ? "one has" : fmt::format("{} have", unsettled.size())),
          command_of(run, change)};
}

auto impact_of(const ResultRow& r) {
  return std::tuple(r.q, r.phi_d_deg, r.v_imp_cm_per_s, r.theta_imp_deg, r.particles_per_target,
                    r.seed);
}

/// Results of a sweep that it does not ask for are impacts that were let go on: they have the later
/// end, and what they went on from needs no other.
auto gone_on(const std::vector<ResultRow>& results, const sweeps::Plan& plan) {
  std::set<std::string> planned;
  for (const db::NewJob& job : plan.jobs) planned.insert(job.hash);
  std::set<decltype(impact_of(results.front()))> found;
  for (const ResultRow& row : results)
    if (!planned.contains(row.hash)) found.insert(impact_of(row));
  return found;
}

void add_longer(std::vector<NextStep>& steps, const TypedRun& run, const sweeps::Plan& plan,
                const std::vector<ResultRow>& results, const job_folder::JobFolder& jobs) {
  std::vector<ResultRow> can_go_on, others;
  const auto have_gone_on = gone_on(results, plan);
  for (const ResultRow& row : results)
    if (!row.result.settled && !have_gone_on.contains(impact_of(row)))
      (job_folder::may_be_extended(jobs.of(row.hash)) ? can_go_on : others).push_back(row);
  steps.push_back(extended(run, plan, can_go_on));
  steps.push_back(longer(run, plan, others));
}

/// A value of an axis between its neighbours at half the distance: "[18, 20, 22]".
std::string finer_values(const sweeps::Axis& axis, double at) {
  std::vector<double> values;
  for (const json& value : axis.values) values.push_back(value.get<double>());
  std::ranges::sort(values);
  const auto here = std::ranges::find(values, sweeps::rounded(at));
  if (here == values.end() || values.size() < 2) return "";
  std::vector<double> finer;
  if (here != values.begin()) finer.push_back(sweeps::rounded((here[-1] + *here) / 2));
  finer.push_back(*here);
  if (here + 1 != values.end()) finer.push_back(sweeps::rounded((*here + here[1]) / 2));
  return fmt::format("[{}]", fmt::join(finer, ", "));
}

/// The axes of a grid about an impact that halve the steps of a sweep's.
std::string finer_grid(const sweeps::Sweep& sweep, const ResultRow& about) {
  std::string text;
  for (const auto& [path, name, at] : {std::tuple(speed, "v_imp_cm_per_s", about.v_imp_cm_per_s),
                                       std::tuple(angle, "theta_imp_deg", about.theta_imp_deg)}) {
    const sweeps::Axis* axis = axis_of(sweep, path);
    const std::string values = axis == nullptr ? "" : finer_values(*axis, at);
    if (!values.empty())
      text += fmt::format("{}\"{}\": {}", text.empty() ? "" : ", ", name, values);
  }
  return text;
}

void add_elongated_or_nearest(std::vector<NextStep>& steps, const TypedRun& run,
                              const sweeps::Plan& plan, const std::vector<ResultRow>& results) {
  const auto show = [&](const ResultRow& row) {
    return "eerie show " + row.hash.substr(0, 8) + in_database(run);
  };
  const auto elongated =
      std::ranges::find_if(results, [](const ResultRow& r) { return r.result.n_eer > 0; });
  if (elongated != results.end()) {
    steps.push_back({"look at an impact with an elongated remnant", show(*elongated)});
    return;
  }
  const ResultRow* nearest = nullptr;
  for (const ResultRow& row : results)
    if (row.result.b_over_a &&
        (nearest == nullptr || *row.result.b_over_a < *nearest->result.b_over_a))
      nearest = &row;
  if (nearest == nullptr) return;
  steps.push_back(
      {fmt::format("look at the nearest to an elongated remnant, b/a {:.2f} at {:g} "
                   "cm/s and {:g} deg",
                   *nearest->result.b_over_a, nearest->v_imp_cm_per_s, nearest->theta_imp_deg),
       show(*nearest)});
  if (const std::string grid = finer_grid(plan.sweep, *nearest); !grid.empty())
    steps.push_back({"a finer grid about it, for the sweep file", grid});
}

/// A map of what was run. Several settings or mass ratios are drawn beside the database already.
void add_map_and_facts(std::vector<NextStep>& steps, const TypedRun& run,
                       const std::vector<ResultRow>& results) {
  std::set<std::tuple<double, double, std::int64_t>> maps;
  for (const ResultRow& row : results) maps.emplace(row.q, row.phi_d_deg, row.settings);
  if (maps.size() == 1) {
    const auto& [q, phi_d, settings] = *maps.begin();
    steps.push_back(
        {"draw a map of b/a", fmt::format("eerie map{} --q {} --phi-d {} --settings {} -o map.png",
                                          in_database(run), q, phi_d, settings)});
  }
  steps.push_back({"hold it against the paper", "eerie check" + in_database(run)});
}

/// The same sweep one rung up, where the sweep leaves that free.
void add_finer(std::vector<NextStep>& steps, const TypedRun& run, const sweeps::Plan& plan) {
  const std::string& fidelity = plan.jobs.front().fidelity;
  const bool one = std::ranges::all_of(
      plan.jobs, [&](const db::NewJob& job) { return job.fidelity == fidelity; });
  const std::string finer(one ? sweeps::rung_above(fidelity) : "");
  if (finer.empty()) return;
  const json settings = sweeps::settings_of(finer).flatten();
  for (const auto& [pointer, ignored] : settings.items())
    if (varies(plan.sweep, dotted(pointer))) return;
  TypedRun again = run;
  again.changes.fidelity = finer;
  if (const std::string command = command_of(again); !command.empty())
    steps.push_back({"the same, finer", command});
}

}  // namespace

std::string command_of(const TypedRun& run, const std::string& more) {
  if (!text::is_named_file(run.sweep)) return "";
  std::string command = "eerie run " + shell_word(run.sweep.string()) + in_database(run);
  if (!run.changes.fidelity.empty()) command += " --fidelity " + run.changes.fidelity;
  for (const std::string& change : run.changes.overrides) command += " --set " + shell_word(change);
  for (const std::string& word : run.options) command += " " + shell_word(word);
  return more.empty() ? command : command + " " + more;
}

std::vector<NextStep> next_steps(const TypedRun& run, const sweeps::Plan& plan,
                                 const manager::Tally& tally, const std::vector<ResultRow>& results,
                                 const job_folder::JobFolder& jobs) {
  std::vector<NextStep> steps;
  if (tally.paused > 0)
    steps.push_back({"let the paused jobs go on", "eerie resume --all" + in_database(run)});
  if (tally.left > 0) steps.push_back({"go on", command_of(run)});
  if (tally.failed > 0)
    steps.push_back({"try the failed jobs once more", command_of(run, "--retry-failed")});
  add_longer(steps, run, plan, results, jobs);
  if (!results.empty()) {
    add_elongated_or_nearest(steps, run, plan, results);
    add_map_and_facts(steps, run, results);
    if (tally.left == 0) add_finer(steps, run, plan);
  }
  std::erase_if(steps, [](const NextStep& step) { return step.command.empty(); });
  return steps;
}

std::string text_of(const std::vector<NextStep>& steps) {
  std::string lines = steps.empty() ? "" : "\nnext:\n";
  for (const NextStep& step : steps)
    lines += fmt::format("  {}:\n    {}\n", step.purpose, text::plain_text(step.command));
  return lines;
}

json to_json(const std::vector<NextStep>& steps) {
  json list = json::array();
  for (const NextStep& step : steps)
    list.push_back({{"purpose", step.purpose}, {"command", step.command}});
  return list;
}

}  // namespace eerie::overview
