#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/study_options.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/studies/particles_needed.hpp"
#include "campaign/studies/study_diagnosis.hpp"
#include "campaign/studies/study_page.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct ConvergeArguments {
  StudyArguments work;
  fs::path folder;
};

std::string range(const statistics::Ensemble& e, int digits) {
  if (e.runs == 0) return "-";
  if (e.runs == 1) return fmt::format("{:.{}f}", e.mean, digits);
  return fmt::format("{:.{}f} +- {:.{}f}", e.mean, digits, e.deviation, digits);
}

std::string table_of(const std::vector<studies::StudyCell>& cells) {
  std::vector<std::vector<std::string>> rows = {{"case", "scheme", "particles", "runs", "b/a",
                                                 "c/a", "M_1/M", "period h", "P(EER of 3)",
                                                 "unsettled", "core-s"}};
  for (const studies::StudyCell& c : cells)
    rows.push_back({c.case_name, c.scheme, fmt::format("{}", c.particles_per_target),
                    fmt::format("{}", c.m_1.runs), range(c.b_over_a, 3), range(c.c_over_a, 3),
                    range(c.m_1, 3), range(c.period_h, 1), fmt::format("{:.2f}", c.p_top3_eer),
                    fmt::format("{:.2f}", c.unsettled),
                    fmt::format("{:.0f}", c.core_seconds.mean)});
  return text_table(rows);
}

/// From which particle number on each scheme is right.
std::string reach_table(const std::vector<studies::Reach>& reaches) {
  const auto from = [](std::optional<std::int64_t> n, bool is_known) {
    return n ? fmt::format("{}", *n) : std::string(is_known ? "not yet" : "-");
  };
  std::vector<std::vector<std::string>> rows = {{"case", "scheme", "finest", "near it from",
                                                 "as published from", "b/a known to",
                                                 "b/a as N grows"}};
  for (const studies::Reach& r : reaches) {
    const std::string limit =
        r.b_over_a ? fmt::format("{:.3f} +- {:.3f}", r.b_over_a->value, r.b_over_a->error) : "-";
    rows.push_back({r.case_name, r.scheme, fmt::format("{}", r.finest), from(r.own, false),
                    from(r.published, r.has_published),
                    r.known_to ? fmt::format("{:.3f}", *r.known_to) : "-", limit});
  }
  return text_table(rows);
}

std::vector<fs::path> write_all(const studies::Study& study,
                                const std::vector<studies::StudyResult>& results,
                                const std::vector<studies::StudyCell>& cells,
                                const std::vector<studies::Reach>& reaches, const fs::path& folder,
                                const std::optional<job_folder::JobFolder>& jobs) {
  std::vector<fs::path> files = {folder / "runs.csv", folder / "convergence.csv",
                                 folder / "reach.csv", folder / "results.md"};
  install_text(files[0], studies::runs_csv(results));
  install_text(files[1], studies::cells_csv(cells));
  install_text(files[2], studies::reaches_csv(reaches));
  install_text(files[3], studies::study_page(study, cells, reaches));
  if (jobs) {
    files.push_back(folder / "diagnosis.csv");
    install_text(files.back(), studies::diagnosis_csv(study, results, *jobs));
  }
  const auto draw = [&](const std::string& name,
                        const std::optional<figures::ConvergenceFigure>& figure) {
    if (!figure) return;
    files.push_back(folder / (name + ".svg"));
    figures::draw_convergence(files.back(), *figure);
  };
  for (const studies::Study::Case& one : study.cases) {
    draw(one.name, studies::figure_of(study, one, cells));
    if (jobs) draw(one.name + "-diagnosis", studies::diagnosis_figure(study, one, results, *jobs));
  }
  return files;
}

int converge(const ConvergeArguments& a) {
  const studies::Study study = studies::load_study(a.work.study);
  auto [left, results, jobs] =
      watch_study(a.work, study, studies::runs_of(study));
  if (results.empty())
    throw InputError(fmt::format("{}: the database {} has no result of this study{}",
                                 a.work.study.string(), a.work.plan.database.string(),
                                 a.work.plan.known.empty() ? "" : ", nor have the known tables"));
  make_folder_of(a.folder / "runs.csv");
  studies::look_up_published_time(study, results, jobs);
  const std::vector<studies::StudyCell> cells = studies::cells_of(study, results);
  const std::vector<studies::Reach> reaches = studies::reaches_of(study, cells);
  const std::vector<fs::path> files = write_all(study, results, cells, reaches, a.folder, jobs);
  if (a.work.json) {
    json names = json::array();
    for (const fs::path& file : files) names.push_back(file.string());
    fmt::print("{}\n", json{{"study", study.name},
                            {"results", results.size()},
                            {"failed", left.failed},
                            {"left", left.left},
                            {"files", std::move(names)}}
                           .dump(1));
  } else {
    fmt::print("\n{}\n{}\n{} results", table_of(cells), reach_table(reaches), results.size());
    if (left.failed > 0) fmt::print(", {} failed (eerie status says why)", left.failed);
    if (left.left > 0) fmt::print(", {} left", left.left);
    fmt::print("\n");
    for (const fs::path& file : files) fmt::print("{}\n", file.string());
  }
  return study_exit(left);
}

}  // namespace

Action add_converge(CLI::App& app) {
  auto a = std::make_shared<ConvergeArguments>();
  add_study(app, a->work);
  app.add_option("-o,--output", a->folder, "folder for figures and tables")->required();
  return [a] { return converge(*a); };
}

}  // namespace eerie::cli
