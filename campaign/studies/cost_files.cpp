#include "campaign/studies/cost_files.hpp"

#include <fmt/format.h>

#include "solver/base/file.hpp"

namespace eerie::studies {
namespace fs = std::filesystem;
using text::shown;

namespace {

/// "0.021 (0.013)": the error, and what the seeds' spread alone would give.
std::string text(const Deviation& d) { return fmt::format("{:.3f} ({:.3f})", d.error, d.noise); }

/// FILE with another end.
fs::path beside(const fs::path& picture, const std::string& end) {
  return picture.parent_path() / (picture.stem().string() + end);
}

}  // namespace

text::Table table_of_points(const CostStudy& study, const std::vector<CostPoint>& points) {
  using Point = CostPoint;
  return text::table_of<Point>(
      {{shown("knob"), [&](const Point& p) { return study.settings[p.setting].knob; }},
       {shown("setting"), [&](const Point& p) { return study.settings[p.setting].label; }},
       {shown("runs"), [](const Point& p) { return p.runs; }},
       {shown("core-s", "{:.1f}"), [](const Point& p) { return p.core_seconds; }},
       {shown("b/a"), [](const Point& p) { return text(p.b_over_a); }},
       {shown("c/a"), [](const Point& p) { return text(p.c_over_a); }},
       {shown("M_1/M"), [](const Point& p) { return text(p.m_1); }},
       {shown("period"), [](const Point& p) { return text(p.period); }},
       {shown("class", "{:.2f}"), [](const Point& p) { return p.class_agreement; }},
       {shown("cost/frontier"),
        [](const Point& p) {
          return fmt::format("{:.2f}{}", p.cost_over_frontier, p.frontier ? " *" : "");
        }}},
      points);
}

std::vector<fs::path> write_cost_study(const CostStudy& study,
                                       const std::vector<CostResult>& results,
                                       const std::vector<CostPoint>& points,
                                       const fs::path& picture) {
  const std::vector<CostCell> cells = cost_cells(study, results);
  const std::vector<fs::path> files = {
      picture, beside(picture, ".csv"), beside(picture, "-runs.csv"),
      beside(picture, "-cases" + picture.extension().string()), beside(picture, "-cases.csv")};
  figures::draw_accuracy(files[0], cost_figure(study, points));
  install_text(files[1], cost_csv(study, points));
  install_text(files[2], cost_runs_csv(study, results));
  figures::draw_matrix(files[3], cost_matrix(study, cells));
  install_text(files[4], cost_cells_csv(study, cells));
  return files;
}

}  // namespace eerie::studies
