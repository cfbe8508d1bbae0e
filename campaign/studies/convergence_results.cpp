#include "campaign/studies/convergence_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "campaign/job_folder/history.hpp"
#include "campaign/results/run_statistics.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/text/csv.hpp"

namespace eerie::studies {

namespace {

using Runs = results::RunGroup<ConvergenceRun>;

ConvergenceCell::AtPublished at_published(Runs runs) {
  std::erase_if(runs, [](const ConvergenceResult* r) { return r->at_published.empty(); });
  if (runs.empty()) return {};
  return {
      results::ensemble_of(
          runs, [](const ConvergenceResult& r) { return r.at_published.front().b_over_a; }),
      results::ensemble_of(runs,
                           [](const ConvergenceResult& r) -> std::optional<double> {
                             return r.at_published.front().mass_over_total;
                           }),
      results::ensemble_of(
          runs, [](const ConvergenceResult& r) { return r.at_published.front().spin_period_h; }),
      results::fraction_of(runs, [](const ConvergenceResult& r) {
        return results::has_eer(r.row.result, r.at_published, results::EerAmong::three_largest);
      })};
}

ConvergenceCell cell_of(const Runs& runs) {
  const ConvergenceRun& first = runs.front()->run;
  return {
      first.scheme,
      first.case_name,
      first.particles_per_target,
      results::ensemble_of(runs, results::of_largest(&db::Remnant::b_over_a)),
      results::ensemble_of(runs, results::of_largest(&db::Remnant::c_over_a)),
      results::ensemble_of(runs, results::largest_mass),
      results::ensemble_of(runs, results::of_largest(&db::Remnant::spin_period_h)),
      results::ensemble_of(runs, results::core_seconds_of),
      results::fraction_of(runs, [](const ConvergenceResult& r) { return !r.row.result.settled; }),
      results::p_eer(runs, results::EerAmong::three_largest),
      results::classes_of(runs),
      at_published(runs)};
}

figures::ConvergencePoint point(const ConvergenceCell& cell, const statistics::Ensemble& e) {
  return {static_cast<double>(cell.particles_per_target), e.mean, e.deviation, e.low, e.high};
}

/// The last look of remnants.csv at `time_s` or before; the largest first.
std::vector<db::Remnant> remnants_at(const job_folder::JobDirectory& job, double time_s) {
  const job_folder::RowLog<ending::RemnantLook> looks(job.remnants());
  std::vector<db::Remnant> remnants;
  double seen_at = -1;
  for (const ending::RemnantLook& seen : looks.rows()) {
    if (seen.time_s > time_s) break;
    if (seen.time_s != seen_at) remnants.clear();
    seen_at = seen.time_s;
    if (seen.rank == 0) continue;
    db::Remnant& m = remnants.emplace_back();
    m.rank = seen.rank, m.mass_over_total = seen.mass_over_total;
    m.b_over_a = seen.b_over_a, m.c_over_a = seen.c_over_a;
    if (seen.turns_per_h > 0) m.spin_period_h = 1 / seen.turns_per_h;
  }
  return remnants;
}

}  // namespace

void look_up_published_time(const ConvergenceStudy& study, std::vector<ConvergenceResult>& results,
                            const std::optional<job_folder::JobFolder>& jobs) {
  for (ConvergenceResult& r : results) {
    if (r.published_at_s != study.published_at_s) r.at_published.clear();  // another study's
    r.published_at_s = study.published_at_s;
    if (!study.published_at_s || !r.at_published.empty()) continue;
    if (r.row.result.ended_at_s.value_or(0) <= *study.published_at_s)
      r.at_published = r.remnants;
    else if (jobs)
      r.at_published = remnants_at(jobs->of(r.row.hash), *study.published_at_s);
  }
}

std::string runs_csv(const std::vector<ConvergenceResult>& results) {
  std::string csv =
      "scheme,case,particles_per_target,seed,class,settled,ended_at_s,end_reason,"
      "m_lr_over_m_total,m_slr_over_m_total";
  csv += results::remnant_header("") + ",published_at_s" + results::remnant_header("_at_published");
  csv += results::run_end_header;
  for (const ConvergenceResult& r : results) {
    const db::Result& x = r.row.result;
    csv += fmt::format("{},{},{},{},{},{},{},{},{:.6g},{:.6g}", r.run.scheme, r.run.case_name,
                       r.run.particles_per_target, r.run.seed, x.outcome_class, x.settled ? 1 : 0,
                       text::csv_number(x.ended_at_s), x.end_reason, x.m_lr_over_m_total,
                       x.m_slr_over_m_total);
    csv += results::remnant_fields(r.remnants);
    csv += "," + text::csv_number(r.published_at_s) + results::remnant_fields(r.at_published);
    csv += results::run_end_fields(r.row, r.core_seconds);
  }
  return csv;
}

std::vector<ConvergenceCell> cells_of(const ConvergenceStudy& study,
                                      const std::vector<ConvergenceResult>& results) {
  std::vector<ConvergenceCell> cells;
  std::set<std::int64_t> particle_numbers;
  for (const ConvergenceStudy::Rung& rung : study.ladder)
    particle_numbers.insert(rung.particles_per_target);
  for (const ConvergenceStudy::Case& one : study.cases)
    for (const std::string& scheme : study.schemes)
      for (const std::int64_t particles : particle_numbers) {
        Runs runs;
        for (const ConvergenceResult& r : results)
          if (r.run.case_name == one.name && r.run.scheme == scheme &&
              r.run.particles_per_target == particles)
            runs.push_back(&r);
        if (!runs.empty()) cells.push_back(cell_of(runs));
      }
  return cells;
}

std::string cells_csv(const std::vector<ConvergenceCell>& cells) {
  std::string csv = "scheme,case,particles_per_target,runs";
  for (const char* name : {"b_over_a", "c_over_a", "m_1_over_m_total", "period_h", "core_s"})
    csv += fmt::format(",{0}_mean,{0}_deviation,{0}_min,{0}_max", name);
  csv += ",unsettled,p_top3_eer,classes,runs_at_published";
  for (const char* name : {"b_over_a", "m_1_over_m_total", "period_h"})
    csv += fmt::format(",{0}_at_published_mean,{0}_at_published_deviation", name);
  csv += ",p_top3_eer_at_published\n";
  for (const ConvergenceCell& c : cells) {
    csv += fmt::format("{},{},{},{}", c.scheme, c.case_name, c.particles_per_target, c.m_1.runs);
    for (const statistics::Ensemble* e :
         {&c.b_over_a, &c.c_over_a, &c.m_1, &c.period_h, &c.core_seconds})
      csv += e->runs == 0 ? ",,,,"
                          : fmt::format(",{:.4g},{:.3g},{:.4g},{:.4g}", e->mean, e->deviation,
                                        e->low, e->high);
    csv += fmt::format(",{:.3g},{:.3g},{}", c.unsettled, c.p_top3_eer, c.classes);
    const ConvergenceCell::AtPublished& then = c.at_published;
    csv += fmt::format(",{}", then.m_1.runs);
    for (const statistics::Ensemble* e : {&then.b_over_a, &then.m_1, &then.period_h})
      csv += e->runs == 0 ? ",," : fmt::format(",{:.4g},{:.3g}", e->mean, e->deviation);
    csv += then.m_1.runs == 0 ? ",\n" : fmt::format(",{:.3g}\n", then.p_top3_eer);
  }
  return csv;
}

std::optional<figures::ConvergenceFigure> figure_of(const ConvergenceStudy& study,
                                                    const ConvergenceStudy::Case& one,
                                                    const std::vector<ConvergenceCell>& cells) {
  figures::ConvergenceFigure figure{
      one.title,
      study.schemes,
      {{"b/a of the largest", one.published.b_over_a, {}},
       {"mass of the largest / all", one.published.m_1_over_m_total, {}},
       {"spin period (h)", one.published.period_h, {}}}};
  for (figures::ConvergencePanel& panel : figure.panels) {
    panel.series.resize(study.schemes.size());
    panel.earlier.resize(study.schemes.size());
  }
  bool any = false;
  for (std::size_t s = 0; s < study.schemes.size(); ++s)
    for (const ConvergenceCell& cell : cells) {
      if (cell.case_name != one.name || cell.scheme != study.schemes[s]) continue;
      any = true;
      const ConvergenceCell::AtPublished& then = cell.at_published;
      const statistics::Ensemble* quantities[] = {&cell.b_over_a, &cell.m_1, &cell.period_h};
      const statistics::Ensemble* earlier[] = {&then.b_over_a, &then.m_1, &then.period_h};
      for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        if (quantities[p]->runs > 0)
          figure.panels[p].series[s].push_back(point(cell, *quantities[p]));
        if (earlier[p]->runs == 0 || earlier[p]->mean == quantities[p]->mean) continue;
        figure.panels[p].earlier[s].push_back(point(cell, *earlier[p]));
        figure.earlier = fmt::format("at {:g} s", study.published_at_s.value_or(0));
      }
    }
  if (!any) return {};
  return figure;
}

}  // namespace eerie::studies
