#pragma once

#include <string>
#include <vector>

#include "analysis/figures/accuracy_figure.hpp"
#include "campaign/results/run_statistics.hpp"
#include "campaign/studies/cost_study.hpp"

namespace eerie::studies {

using CostResult = results::RunWithResult<CostRun>;

/// The runs of one setting and case.
results::RunGroup<CostRun> runs_with(const std::vector<CostResult>& results, std::size_t setting,
                                     std::size_t case_index);

/// The difference between the results of one setting and those of the reference, over the cases of
/// a study.
struct Deviation {
  double error = 0;  ///< root mean square of the differences between the ensembles' means
  double noise = 0;  ///< the error that the spread of the seeds alone would give
};

/// One setting: the cost of an impact, and the errors of its results.
struct CostPoint {
  std::size_t setting = 0;
  std::size_t runs = 0;
  std::string cases;                            ///< the impacts that have results, "A, G"
  bool whole = true;                            ///< whether these are all impacts of the study
  double core_seconds = 0, particle_steps = 0;  ///< per impact, mean over the cases
  Deviation b_over_a, c_over_a, m_1,
      period;  ///< of the largest remnant; that of the period is relative
  /// Fraction of the runs that have the most frequent class of the reference.
  double class_agreement = 0;
  double p_any_eer_error = 0;  ///< mean over the cases of |P(EER) - that of the reference|
  bool frontier = false;       ///< whether no setting of the same accuracy is cheaper
  /// The cost in units of that of the cheapest setting of the same accuracy. Differences below the
  /// noise do not count.
  double cost_over_frontier = 1;
};

/// One point per setting with results of some case. There are no points unless the reference has
/// results of every case. A point that lacks a case is not part of the frontier, since its cost and
/// error belong to the other cases. Spreads are pooled over the settings of a case, since few seeds
/// say little about their own spread.
std::vector<CostPoint> cost_points(const CostStudy& study, const std::vector<CostResult>& results);

/// A CSV table with one line per setting, and units in the header.
std::string cost_csv(const CostStudy& study, const std::vector<CostPoint>& points);
/// A CSV table with one line per run.
std::string cost_runs_csv(const CostStudy& study, const std::vector<CostResult>& results);

figures::AccuracyFigure cost_figure(const CostStudy& study, const std::vector<CostPoint>& points);

}  // namespace eerie::studies
