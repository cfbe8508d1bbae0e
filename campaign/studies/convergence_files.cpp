#include "campaign/studies/convergence_files.hpp"

#include <fmt/format.h>

#include "campaign/studies/convergence_diagnosis.hpp"
#include "campaign/studies/convergence_page.hpp"
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

text::Table table_of_cells(const std::vector<ConvergenceCell>& cells) {
  using Cell = ConvergenceCell;
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

text::Table table_of_particles_needed(const std::vector<ParticlesNeeded>& needed) {
  return table_of<ParticlesNeeded>(
      {{shown("case"), [](const ParticlesNeeded& r) { return r.case_name; }},
       {shown("scheme"), [](const ParticlesNeeded& r) { return r.scheme; }},
       {shown("finest"), [](const ParticlesNeeded& r) { return r.finest; }},
       {shown("near it from"), [](const ParticlesNeeded& r) { return or_null(r.own); }},
       {shown("as published from"),
        [](const ParticlesNeeded& r) {
          return r.has_published && !r.published ? Value("not yet") : or_null(r.published);
        }},
       {shown("b/a known to", "{:.3f}"),
        [](const ParticlesNeeded& r) { return or_null(r.known_to); }},
       {shown("b/a as N grows"),
        [](const ParticlesNeeded& r) {
          return r.b_over_a
                     ? Value(fmt::format("{:.3f} +- {:.3f}", r.b_over_a->value, r.b_over_a->error))
                     : Value();
        }}},
      needed);
}

std::vector<fs::path> write_convergence_study(const ConvergenceStudy& study,
                                              const std::vector<ConvergenceResult>& results,
                                              const fs::path& folder,
                                              const std::optional<job_folder::JobFolder>& jobs) {
  const std::vector<ConvergenceCell> cells = cells_of(study, results);
  const std::vector<ParticlesNeeded> needed = particles_needed(study, cells);
  std::vector<fs::path> files = {folder / "runs.csv", folder / "convergence.csv",
                                 folder / "reach.csv", folder / "results.md"};
  install_text(files[0], runs_csv(results));
  install_text(files[1], cells_csv(cells));
  install_text(files[2], particles_needed_csv(needed));
  install_text(files[3], convergence_page(study, cells, needed));
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
  for (const ConvergenceStudy::Case& one : study.cases) {
    draw(one.name, figure_of(study, one, cells));
    if (jobs) draw(one.name + "-diagnosis", diagnosis_figure(study, one, results, *jobs));
  }
  return files;
}

}  // namespace eerie::studies
