#pragma once

#include <string>
#include <vector>

#include "analysis/figures/accuracy_figure.hpp"
#include "campaign/results/run_statistics.hpp"
#include "campaign/studies/cost_study.hpp"

namespace eerie::studies {

using CostResult = results::RunWithResult<CostRun>;

/// Those of one setting and case.
results::RunGroup<CostRun> runs_with(const std::vector<CostResult>& results, std::size_t setting,
                                     std::size_t case_index);

/// How far the answers of one setting are from the reference's, over the cases of a study.
struct Deviation {
  double error = 0;  ///< root mean square of the differences between the ensembles' means
  double noise = 0;  ///< what error would be by the spread of the seeds alone
};

/// One setting: what an impact costs with it and how far its answers are off.
struct CostPoint {
  std::size_t setting = 0;
  std::size_t runs = 0;
  std::string cases;                            ///< the impacts that it has results of, "A, G"
  bool whole = true;                            ///< these are all
  double core_seconds = 0, particle_steps = 0;  ///< per impact, mean over the cases
  Deviation b_over_a, c_over_a, m_1, period;    ///< of the largest remnant; period: relative
  double class_agreement = 0;  ///< part of the runs with the class that most of the reference have
  double p_any_eer_error = 0;  ///< mean over the cases of |P(EER) - that of the reference|
  bool frontier = false;       ///< nothing that is as true is cheaper
  /// Cost over that of the cheapest setting that is as true; differences below noise are none.
  double cost_over_frontier = 1;
};

/// One point per setting that has results of some case; none without the reference's of every case.
/// A point of some cases only is no part of the frontier: its cost and error are those of these.
/// Spreads are
/// pooled over the settings of a case, since few seeds say little of their own spread.
std::vector<CostPoint> cost_points(const CostStudy& study, const std::vector<CostResult>& results);

/// One line per setting, units in the header.
std::string cost_csv(const CostStudy& study, const std::vector<CostPoint>& points);
/// One line per run.
std::string cost_runs_csv(const CostStudy& study, const std::vector<CostResult>& results);

figures::AccuracyFigure cost_figure(const CostStudy& study, const std::vector<CostPoint>& points);

}  // namespace eerie::studies
