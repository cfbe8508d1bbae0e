#include "campaign/studies/study_files.hpp"

#include <fmt/format.h>

#include "campaign/studies/study_diagnosis.hpp"
#include "campaign/studies/study_page.hpp"
#include "solver/base/file.hpp"

namespace eerie::studies {
namespace fs = std::filesystem;
using text::or_null, text::shown, text::table_of;
using text::Value;

namespace {

/// "0.240 +- 0.013", for people.
Value range(const statistics::Ensemble& e, int digits) {
  if (e.runs == 0) return {};
  const std::string mean = fmt::format("{:.{}f}", e.mean, digits);
  return e.runs == 1 ? mean : fmt::format("{} +- {:.{}f}", mean, e.deviation, digits);
}

}  // namespace

text::Table table_of_cells(const std::vector<StudyCell>& cells) {
  using Cell = StudyCell;
  return table_of<Cell>(
      {{shown("case"), [](const Cell& c) { return c.case_name; }},
       {shown("scheme"), [](const Cell& c) { return c.scheme; }},
       {shown("particles"), [](const Cell& c) { return c.particles_per_target; }},
       {shown("runs"), [](const Cell& c) { return c.m_1.runs; }},
       {shown("b/a"), [](const Cell& c) { return range(c.b_over_a, 3); }},
       {shown("c/a"), [](const Cell& c) { return range(c.c_over_a, 3); }},
       {shown("M_1/M"), [](const Cell& c) { return range(c.m_1, 3); }},
       {shown("period h"), [](const Cell& c) { return range(c.period_h, 1); }},
       {shown("P(EER of 3)", "{:.2f}"), [](const Cell& c) { return c.p_top3_eer; }},
       {shown("unsettled", "{:.2f}"), [](const Cell& c) { return c.unsettled; }},
       {shown("core-s", "{:.0f}"), [](const Cell& c) { return c.core_seconds.mean; }}},
      cells);
}

text::Table table_of_reaches(const std::vector<Reach>& reaches) {
  return table_of<Reach>(
      {{shown("case"), [](const Reach& r) { return r.case_name; }},
       {shown("scheme"), [](const Reach& r) { return r.scheme; }},
       {shown("finest"), [](const Reach& r) { return r.finest; }},
       {shown("near it from"), [](const Reach& r) { return or_null(r.own); }},
       {shown("as published from"),
        [](const Reach& r) {
          return r.has_published && !r.published ? Value("not yet") : or_null(r.published);
        }},
       {shown("b/a known to", "{:.3f}"), [](const Reach& r) { return or_null(r.known_to); }},
       {shown("b/a as N grows"),
        [](const Reach& r) {
          return r.b_over_a
                     ? Value(fmt::format("{:.3f} +- {:.3f}", r.b_over_a->value, r.b_over_a->error))
                     : Value();
        }}},
      reaches);
}

std::vector<fs::path> write_study(const Study& study, const std::vector<StudyResult>& results,
                                  const fs::path& folder,
                                  const std::optional<job_folder::JobFolder>& jobs) {
  const std::vector<StudyCell> cells = cells_of(study, results);
  const std::vector<Reach> reaches = reaches_of(study, cells);
  std::vector<fs::path> files = {folder / "runs.csv", folder / "convergence.csv",
                                 folder / "reach.csv", folder / "results.md"};
  install_text(files[0], runs_csv(results));
  install_text(files[1], cells_csv(cells));
  install_text(files[2], reaches_csv(reaches));
  install_text(files[3], study_page(study, cells, reaches));
  if (jobs) {
    files.push_back(folder / "diagnosis.csv");
    install_text(files.back(), diagnosis_csv(study, results, *jobs));
  }
  const auto draw = [&](const std::string& name,
                        const std::optional<figures::ConvergenceFigure>& figure) {
    if (!figure) return;
    files.push_back(folder / (name + ".svg"));
    figures::draw_convergence(files.back(), *figure);
  };
  for (const Study::Case& one : study.cases) {
    draw(one.name, figure_of(study, one, cells));
    if (jobs) draw(one.name + "-diagnosis", diagnosis_figure(study, one, results, *jobs));
  }
  return files;
}

}  // namespace eerie::studies
