#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/check_report.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/maps/map.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;

struct CheckArguments {
  fs::path database;
  fs::path report;       ///< empty: none
  db::MapFilter filter;  ///< of settings only
  bool json = false;
};

/// The maps beside the report, "REPORT-q1-phi40-n1000.svg"; without gnuplot the report says so.
void draw_maps(CheckReport& report, const db::Connection& connection, const db::MapFilter& filter,
               const fs::path& file) {
  const std::vector<diagrams::PhaseDiagram> diagrams = maps::phase_diagrams(connection, filter);
  for (const diagrams::PhaseDiagram& diagram : diagrams) {
    const fs::path figure = file.parent_path() / fmt::format("{}-{}.svg", file.stem().string(),
                                                             maps::map_label(diagram, diagrams));
    try {
      diagrams::draw_phase_diagram(figure, diagram);
    } catch (const EnvironmentError& error) {
      report.no_figures = fmt::format("Not drawn: {}", error.what());
      return;
    }
    report.figures.push_back(figure);
  }
}

int check_facts(const CheckArguments& a) {
  if (!a.report.empty() && a.report.extension() != ".md")
    throw InputError(
        fmt::format("-o {}: the report is Markdown; its name must end in .md, for "
                    "example -o report.md",
                    a.report.string()));
  const db::Connection connection(a.database, db::Access::read);
  db::ResultFilter filter;
  filter.fidelity = a.filter.fidelity, filter.settings = a.filter.settings;
  const maps::ImpactRuns runs = maps::impact_runs(connection, filter);
  CheckReport report{a.database, {}, maps::remark(runs), {}, {}};
  for (const paper::Fact& fact : paper::paper_facts())
    report.facts.push_back({&fact, paper::check(fact, runs.runs, a.database.string())});
  if (!a.report.empty()) {
    make_folder_of(a.report);
    draw_maps(report, connection, a.filter, a.report);
    install_text(a.report, check_markdown(report));
  }
  fmt::print("{}", a.json ? to_json(report).dump(1) + "\n" : check_text(report));
  if (a.json || a.report.empty()) return static_cast<int>(ExitCode::done);
  fmt::print("{}\n", a.report.string());
  for (const fs::path& figure : report.figures) fmt::print("{}\n", figure.string());
  return static_cast<int>(ExitCode::done);
}

}  // namespace

Action add_check(CLI::App& app) {
  auto a = std::make_shared<CheckArguments>();
  add_database(app, a->database);
  add_settings_filter(app, a->filter);
  app.add_option("-o,--output", a->report,
                 "write the table, with maps beside it, into this Markdown file (.md)");
  add_json(app, a->json);
  return [a] { return check_facts(*a); };
}

}  // namespace eerie::cli
