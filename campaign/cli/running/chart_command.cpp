#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/study_options.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/studies/cost_cases.hpp"
#include "campaign/studies/cost_errors.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct ChartArguments {
  StudyArguments work;
  fs::path picture;
};

/// "0.021 (0.013)": the error, and what the seeds' spread alone would give.
std::string text(const studies::Deviation& d) {
  return fmt::format("{:.3f} ({:.3f})", d.error, d.noise);
}

std::string table_of(const studies::ChartStudy& study,
                     const std::vector<studies::ChartPoint>& points) {
  std::vector<std::vector<std::string>> rows = {{"knob", "setting", "runs", "core-s", "b/a", "c/a",
                                                 "M_1/M", "period", "class", "cost/frontier"}};
  for (const studies::ChartPoint& p : points) {
    const studies::ChartStudy::Setting& s = study.settings[p.setting];
    rows.push_back({s.knob, s.label, fmt::format("{}", p.runs),
                    fmt::format("{:.1f}", p.core_seconds), text(p.b_over_a), text(p.c_over_a),
                    text(p.m_1), text(p.period), fmt::format("{:.2f}", p.class_agreement),
                    fmt::format("{:.2f}{}", p.cost_over_frontier, p.frontier ? " *" : "")});
  }
  return text_table(rows);
}

/// FILE with another end.
fs::path beside(const fs::path& picture, const std::string& end) {
  return picture.parent_path() / (picture.stem().string() + end);
}

int chart(const ChartArguments& a) {
  const studies::ChartStudy study = studies::load_chart_study(a.work.study);
  const auto [left, results, jobs] =
      watch_study(a.work, study, studies::runs_of(study));
  const std::vector<studies::ChartPoint> points = studies::chart_points(study, results);
  if (points.empty())
    throw InputError(fmt::format(
        "{}: the database {} lacks the reference's result of some case: nothing to measure against",
        a.work.study.string(), a.work.plan.database.string()));
  make_folder_of(a.picture);
  const std::vector<studies::ChartCell> cells = studies::chart_cells(study, results);
  const std::vector<fs::path> files = {a.picture, beside(a.picture, ".csv"),
                                       beside(a.picture, "-runs.csv"),
                                       beside(a.picture, "-cases" + a.picture.extension().string()),
                                       beside(a.picture, "-cases.csv")};
  figures::draw_accuracy(files[0], studies::chart_figure(study, points));
  install_text(files[1], studies::chart_csv(study, points));
  install_text(files[2], studies::chart_runs_csv(study, results));
  figures::draw_matrix(files[3], studies::chart_matrix(study, cells));
  install_text(files[4], studies::chart_cells_csv(study, cells));
  if (a.work.json) {
    fmt::print("{}\n", json{{"study", study.name},
                            {"results", results.size()},
                            {"points", points.size()},
                            {"failed", left.failed},
                            {"left", left.left},
                            {"files", files}}
                           .dump(1));
  } else {
    fmt::print(
        "\n{}\nerrors against the reference, in brackets what the spread of the seeds alone gives; "
        "*: on the frontier of b/a\n{} results\n",
        table_of(study, points), results.size());
    for (const fs::path& file : files) fmt::print("{}\n", file.string());
  }
  return study_exit(left);
}

}  // namespace

Action add_chart(CLI::App& app) {
  auto a = std::make_shared<ChartArguments>();
  add_study(app, a->work);
  app.add_option("-o,--output", a->picture,
                 "picture: .svg, .png or .pdf; its numbers come beside it as CSV")
      ->required();
  return [a] { return chart(*a); };
}

}  // namespace eerie::cli
