#include "campaign/facts/fact_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "campaign/maps/impact_runs.hpp"
#include "campaign/maps/map.hpp"
#include "campaign/text/plain_text.hpp"
#include "solver/base/error.hpp"

namespace eerie::facts {
using text::data, text::or_null, text::shown;
using text::Field, text::Table, text::Value, text::table_of;

namespace {

/// "1000 survey, 6 runs at 1 of 1 impacts".
std::string rests_on(const paper::FactCheck& f) {
  if (f.settings.particles_per_target == 0) return "-";
  std::string text =
      fmt::format("{} particles ({}), {} runs, {}/{} impacts", f.settings.particles_per_target,
                  f.settings.name, f.runs, f.impacts, f.impacts_wanted);
  if (f.finer > 0) text += fmt::format(", {} of them by finer runs", f.finer);
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

constexpr paper::Agreement agreements[] = {paper::Agreement::agrees, paper::Agreement::disagrees,
                                           paper::Agreement::undecided,
                                           paper::Agreement::not_enough};

using Fields = std::vector<Field<CheckedFact>>;

/// What is found, as programs read it.
Fields data_fields() {
  const auto of = [](const char* name, auto member) {
    return Field<CheckedFact>{data(name), [member](const CheckedFact& c) {
                                return Value(std::invoke(member, c.finding));
                              }};
  };
  const auto number = [](const char* name, std::optional<double> paper::FactCheck::*member) {
    return Field<CheckedFact>{
        data(name), [member](const CheckedFact& c) { return or_null(c.finding.*member); }};
  };
  return {{data("name"), [](const CheckedFact& c) { return c.fact->name; }},
          {data("statement"), [](const CheckedFact& c) { return c.fact->statement; }},
          {data("source"), [](const CheckedFact& c) { return c.fact->source; }},
          {data("q"), [](const CheckedFact& c) { return c.fact->q; }},
          {data("phi_d_deg"), [](const CheckedFact& c) { return c.fact->phi_d_deg; }},
          {data("point"),
           [](const CheckedFact& c) {
             return c.fact->point ? Value{{"v_imp_cm_per_s", c.fact->point->v_imp_cm_per_s},
                                          {"theta_imp_deg", c.fact->point->theta_imp_deg}}
                                  : Value();
           }},
          {data("verdict"), [](const CheckedFact& c) { return paper::name(c.finding.agreement); }},
          of("found", &paper::FactCheck::found),
          of("difference", &paper::FactCheck::difference),
          number("paper", &paper::FactCheck::paper),
          number("value", &paper::FactCheck::value),
          number("low", &paper::FactCheck::low),
          number("high", &paper::FactCheck::high),
          {data("particles_per_target"),
           [](const CheckedFact& c) { return c.finding.settings.particles_per_target; }},
          {data("settings"), [](const CheckedFact& c) { return c.finding.settings.name; }},
          of("runs", &paper::FactCheck::runs),
          of("impacts", &paper::FactCheck::impacts),
          of("impacts_wanted", &paper::FactCheck::impacts_wanted),
          of("finer", &paper::FactCheck::finer),
          of("split", &paper::FactCheck::split),
          of("unsettled", &paper::FactCheck::unsettled),
          of("to_run", &paper::FactCheck::to_run)};
}

Table page_table_of(const FactReport& r) {
  return table_of(
      Fields{{shown("fact"), [](const CheckedFact& c) { return c.fact->name; }},
             {shown("of"), [](const CheckedFact& c) { return impact(*c.fact); }},
             {shown("the paper says"), [](const CheckedFact& c) { return c.fact->statement; }},
             {shown("source"), [](const CheckedFact& c) { return c.fact->source; }},
             {shown("verdict"),
              [](const CheckedFact& c) {
                return fmt::format("**{}**", paper::name(c.finding.agreement));
              }},
             {shown("found"), [](const CheckedFact& c) { return c.finding.found; }},
             {shown("difference"), [](const CheckedFact& c) { return c.finding.difference; }},
             {shown("rests on"), [](const CheckedFact& c) { return rests_on(c.finding); }}},
      r.facts);
}

}  // namespace

std::size_t FactReport::count(paper::Agreement agreement) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      facts, [&](const CheckedFact& c) { return c.finding.agreement == agreement; }));
}

std::vector<std::pair<std::string, std::string>> commands_of(const FactReport& r) {
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

std::string summary(const FactReport& r) {
  std::string text;
  for (const paper::Agreement agreement : agreements)
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

nlohmann::json to_json(const FactReport& r) {
  Value report = {{"database", r.database.string()},
                  {"tolerance", paper::check_tolerance},
                  {"min_runs", paper::check_min_runs},
                  {"facts", text::records(table_of(data_fields(), r.facts))},
                  {"remark", r.remark},
                  {"figures", Value::array()}};
  for (const auto& figure : r.figures) report["figures"].push_back(figure.string());
  for (const paper::Agreement agreement : agreements)
    report["counts"][std::string(paper::name(agreement))] = r.count(agreement);
  return report;
}

text::Table table_of_facts(const FactReport& r) {
  return text::table_of(
      Fields{
          {shown("fact"), [](const CheckedFact& c) { return c.fact->name; }},
          {shown("paper"), [](const CheckedFact& c) { return c.fact->statement; }},
          {shown("verdict"), [](const CheckedFact& c) { return paper::name(c.finding.agreement); }},
          {shown("found"),
           [](const CheckedFact& c) {
             return c.finding.found.empty() ? "no run" : c.finding.found;
           }},
          {shown("rests on"), [](const CheckedFact& c) { return rests_on(c.finding); }}},
      r.facts);
}

FactReport check_facts(const db::Connection& connection, const db::MapFilter& settings) {
  db::ResultFilter filter;
  filter.fidelity = settings.fidelity, filter.settings = settings.settings;
  const maps::ImpactRuns runs = maps::impact_runs(connection, filter);
  FactReport report{connection.path(), {}, maps::remark(runs), {}, {}};
  for (const paper::Fact& fact : paper::paper_facts())
    report.facts.push_back({&fact, paper::check(fact, runs.runs, connection.path().string())});
  return report;
}

void draw_maps(FactReport& report, const db::Connection& connection, const db::MapFilter& settings,
               const std::filesystem::path& file) {
  const std::vector<diagrams::PhaseDiagram> diagrams = maps::phase_diagrams(connection, settings);
  for (const diagrams::PhaseDiagram& diagram : diagrams) {
    const std::filesystem::path figure =
        file.parent_path() /
        fmt::format("{}-{}.svg", file.stem().string(), maps::map_label(diagram, diagrams));
    try {
      diagrams::draw_phase_diagram(figure, diagram);
    } catch (const EnvironmentError& error) {
      report.no_figures = fmt::format("Not drawn: {}", error.what());
      return;
    }
    report.figures.push_back(figure);
  }
}

std::string markdown(const FactReport& r) {
  std::string page =
      fmt::format("# The paper's facts against {}\n\nSugiura, Kobayashi & Inutsuka (2019). {}.\n\n",
                  text::plain_text(r.database.filename().string()), summary(r));
  page += text::markdown(page_table_of(r));
  page += "\n" + rules() + " " + other_means + "\n";
  if (!r.remark.empty()) page += fmt::format("\nOf the database: {}.\n", r.remark);
  std::string commands;
  for (const auto& [command, names] : commands_of(r))
    commands += fmt::format("# {}\n{}\n", names, command);
  if (!commands.empty())
    page += "\n## What would decide the open ones\n\n```sh\n" + commands + "```\n";
  if (!r.figures.empty() || !r.no_figures.empty()) page += "\n## Maps\n\n";
  for (const auto& figure : r.figures)
    page += fmt::format("![b/a of the largest remnant]({})\n", figure.filename().string());
  if (!r.no_figures.empty()) page += fmt::format("{}\n", r.no_figures);
  return page;
}

}  // namespace eerie::facts
