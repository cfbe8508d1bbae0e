#include "campaign/cli/output/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/cli/output/text_table.hpp"

namespace eerie::cli {
using nlohmann::json;

namespace {

constexpr const char* other_means =
    "Facts on the disk around the impacts, on friction and on tides are checked by `eerie disk`.";

/// "1000 survey, 6 runs at 1 of 1 impacts".
std::string rests_on(const paper::FactCheck& f) {
  if (f.settings.particles_per_target == 0) return "-";
  std::string text =
      fmt::format("{} particles ({}), {} runs, {}/{} impacts", f.settings.particles_per_target,
                  f.settings.name, f.runs, f.impacts, f.impacts_wanted);
  if (f.split > 0) text += fmt::format(", {} split", f.split);
  if (f.unsettled > 0) text += fmt::format(", {} unsettled", f.unsettled);
  return text;
}

std::string impact(const paper::Fact& fact) {
  std::string text = fmt::format("q {:g}, {:g} deg", fact.q, fact.phi_d_deg);
  if (fact.point)
    text +=
        fmt::format(", {:g} cm/s, {:g} deg", fact.point->v_imp_cm_per_s, fact.point->theta_imp_deg);
  return text;
}

/// Each command that would decide something, with the facts that wait for it, in their order.
std::vector<std::pair<std::string, std::string>> commands_of(const CheckReport& r) {
  std::vector<std::pair<std::string, std::string>> commands;
  for (const CheckedFact& c : r.facts) {
    if (c.finding.to_run.empty()) continue;
    const auto known =
        std::ranges::find(commands, c.finding.to_run, &std::pair<std::string, std::string>::first);
    if (known == commands.end())
      commands.emplace_back(c.finding.to_run, c.fact->name);
    else
      known->second += ", " + c.fact->name;
  }
  return commands;
}

std::string summary(const CheckReport& r) {
  std::string text;
  for (const paper::Agreement agreement :
       {paper::Agreement::agrees, paper::Agreement::disagrees, paper::Agreement::undecided,
        paper::Agreement::not_enough})
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", r.count(agreement),
                        paper::name(agreement));
  return fmt::format("{} facts: {}", r.facts.size(), text);
}

std::string rules() {
  return fmt::format(
      "Numbers agree within {:.0f} % of the paper's value; they disagree when one more run would "
      "be "
      "so far out with a probability below 2.5 %. At least {} runs each. An impact is what at "
      "least "
      "half of its runs are; \"split\": its seeds differ on the matter.",
      100 * paper::check_tolerance, paper::check_min_runs);
}

/// A cell of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

json to_json(const CheckedFact& c) {
  const paper::Fact& fact = *c.fact;
  const paper::FactCheck& f = c.finding;
  json point;
  if (fact.point)
    point = {{"v_imp_cm_per_s", fact.point->v_imp_cm_per_s},
             {"theta_imp_deg", fact.point->theta_imp_deg}};
  return {{"name", fact.name},
          {"statement", fact.statement},
          {"source", fact.source},
          {"q", fact.q},
          {"phi_d_deg", fact.phi_d_deg},
          {"point", point},
          {"verdict", paper::name(f.agreement)},
          {"found", f.found},
          {"difference", f.difference},
          {"paper", or_null(f.paper)},
          {"value", or_null(f.value)},
          {"low", or_null(f.low)},
          {"high", or_null(f.high)},
          {"particles_per_target", f.settings.particles_per_target},
          {"settings", f.settings.name},
          {"runs", f.runs},
          {"impacts", f.impacts},
          {"impacts_wanted", f.impacts_wanted},
          {"split", f.split},
          {"unsettled", f.unsettled},
          {"to_run", f.to_run}};
}

}  // namespace

std::size_t CheckReport::count(paper::Agreement agreement) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      facts, [&](const CheckedFact& c) { return c.finding.agreement == agreement; }));
}

json to_json(const CheckReport& r) {
  json report = {{"database", r.database.string()},
                 {"tolerance", paper::check_tolerance},
                 {"min_runs", paper::check_min_runs},
                 {"facts", json::array()},
                 {"remark", r.remark},
                 {"figures", json::array()}};
  for (const CheckedFact& c : r.facts) report["facts"].push_back(to_json(c));
  for (const paper::Agreement agreement :
       {paper::Agreement::agrees, paper::Agreement::disagrees, paper::Agreement::undecided,
        paper::Agreement::not_enough})
    report["counts"][std::string(paper::name(agreement))] = r.count(agreement);
  for (const auto& figure : r.figures) report["figures"].push_back(figure.string());
  return report;
}

std::string check_text(const CheckReport& r) {
  std::vector<std::vector<std::string>> rows = {{"fact", "paper", "verdict", "found", "rests on"}};
  for (const CheckedFact& c : r.facts)
    rows.push_back({c.fact->name, c.fact->statement, std::string(paper::name(c.finding.agreement)),
                    c.finding.found.empty() ? "no run" : c.finding.found, rests_on(c.finding)});
  std::string text = text_table(rows) + "\n";
  for (const CheckedFact& c : r.facts)
    if (!c.finding.difference.empty())
      text += fmt::format("{}: {}: {}\n", c.fact->name, paper::name(c.finding.agreement),
                          c.finding.difference);
  std::string commands;
  for (const auto& [command, names] : commands_of(r))
    commands += fmt::format("{}:\n    {}\n", names, command);
  if (!commands.empty()) text += "\nwhat would decide the open ones:\n" + commands;
  text += fmt::format("\n{}\n{}\n{}\n", summary(r), rules(), other_means);
  if (!r.remark.empty()) text += r.remark + "\n";
  return text;
}

std::string check_markdown(const CheckReport& r) {
  std::string text = fmt::format(
      "# The paper's facts against {}\n\nSugiura, Kobayashi & Inutsuka (2019). {}.\n\n"
      "| fact | of | the paper says | source | verdict | found | difference | rests on |\n"
      "|---|---|---|---|---|---|---|---|\n",
      r.database.filename().string(), summary(r));
  for (const CheckedFact& c : r.facts) {
    const paper::FactCheck& f = c.finding;
    text += fmt::format("| {} | {} | {} | {} | **{}** | {} | {} | {} |\n", c.fact->name,
                        impact(*c.fact), cell(c.fact->statement), c.fact->source,
                        paper::name(f.agreement), cell(f.found), cell(f.difference), rests_on(f));
  }
  text += "\n" + rules() + " " + other_means + "\n";
  if (!r.remark.empty()) text += "\nOf the database: " + r.remark + ".\n";
  std::string commands;
  for (const auto& [command, names] : commands_of(r))
    commands += fmt::format("# {}\n{}\n", names, command);
  if (!commands.empty())
    text += "\n## What would decide the open ones\n\n```sh\n" + commands + "```\n";
  if (!r.figures.empty() || !r.no_figures.empty()) text += "\n## Maps\n\n";
  for (const auto& figure : r.figures)
    text += fmt::format("![b/a of the largest remnant]({})\n", figure.filename().string());
  if (!r.no_figures.empty()) text += r.no_figures + "\n";
  return text;
}

}  // namespace eerie::cli
