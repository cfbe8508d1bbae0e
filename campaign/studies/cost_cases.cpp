#include "campaign/studies/cost_cases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/results/run_statistics.hpp"
#include "campaign/text/csv.hpp"

namespace eerie::studies {

namespace {

CostCell cell_of(std::size_t setting, std::size_t one, const results::RunGroup<CostRun>& runs) {
  return {setting,
          one,
          results::ensemble_of(runs, results::of_largest(&db::Remnant::b_over_a)),
          results::ensemble_of(runs, results::of_largest(&db::Remnant::c_over_a)),
          results::ensemble_of(runs, results::largest_mass),
          results::ensemble_of(runs, results::of_largest(&db::Remnant::spin_period_h)),
          results::ensemble_of(runs, results::core_seconds_of),
          results::p_eer(runs, results::EerAmong::three_largest),
          results::classes_of(runs)};
}

/// ".95"; what rounds to one as "1.0".
std::string two_digits(double value) {
  const std::string text = fmt::format("{:.2f}", value);
  return text.starts_with('0') ? text.substr(1) : fmt::format("{:.1f}", value);
}

}  // namespace

std::vector<CostCell> cost_cells(const CostStudy& study, const std::vector<CostResult>& results) {
  std::vector<CostCell> cells;
  for (std::size_t s = 0; s < study.settings.size(); ++s)
    for (std::size_t c = 0; c < study.cases.size(); ++c)
      if (const auto runs = runs_with(results, s, c); !runs.empty())
        cells.push_back(cell_of(s, c, runs));
  return cells;
}

std::string cost_cells_csv(const CostStudy& study, const std::vector<CostCell>& cells) {
  std::string csv = "knob,setting,case,runs";
  for (const char* name : {"b_over_a", "c_over_a", "m_1_over_m_total", "period_h", "core_s"})
    csv += fmt::format(",{0}_mean,{0}_deviation", name);
  csv += ",p_top3_eer,classes\n";
  for (const CostCell& x : cells) {
    const CostStudy::Setting& s = study.settings[x.setting];
    csv += fmt::format("{},{},{},{}", text::csv_quoted(s.knob), text::csv_quoted(s.label),
                       study.cases[x.case_index].name, x.m_1.runs);
    for (const statistics::Ensemble* e :
         {&x.b_over_a, &x.c_over_a, &x.m_1, &x.period_h, &x.core_seconds})
      csv += e->runs == 0 ? ",," : fmt::format(",{:.4g},{:.3g}", e->mean, e->deviation);
    csv += fmt::format(",{:.3g},{}\n", x.p_top3_eer, x.classes);
  }
  return csv;
}

figures::MatrixFigure cost_matrix(const CostStudy& study, const std::vector<CostCell>& cells) {
  figures::MatrixFigure figure;
  figure.title = fmt::format("{}: what each setting makes of each impact", study.name);
  figure.caption = "b/a and mass (in parts of all) of the largest remnant; blue: b/a < 0.3";
  bool has_blanks = false;
  for (const CostStudy::Case& one : study.cases) {
    figure.columns.push_back(one.name);
    const bool named = one.title.starts_with(one.name + ":");
    figure.notes.push_back(named ? one.title : fmt::format("{}: {}", one.name, one.title));
  }
  for (std::size_t s = 0; s < study.settings.size(); ++s) {
    if (std::ranges::find(cells, s, &CostCell::setting) == cells.end()) continue;
    const CostStudy::Setting& setting = study.settings[s];
    const bool stands_alone = setting.label.empty();
    const std::string group = stands_alone ? "" : setting.knob;
    if (figure.groups.empty() || figure.groups.back().name != group)
      figure.groups.push_back({group, {}});
    figures::MatrixRow& row = figure.groups.back().rows.emplace_back();
    row.label = stands_alone ? setting.knob : setting.label;
    row.cells.resize(study.cases.size());
    for (const CostCell& x : cells)
      if (x.setting == s && x.b_over_a.runs > 0)
        row.cells[x.case_index] = {
            x.b_over_a.mean,
            fmt::format("{}  {}", two_digits(x.b_over_a.mean), two_digits(x.m_1.mean))};
    has_blanks =
        has_blanks || std::ranges::any_of(row.cells, [](const auto& cell) { return !cell; });
  }
  if (has_blanks) figure.caption += "; blank: not run";
  return figure;
}

}  // namespace eerie::studies
