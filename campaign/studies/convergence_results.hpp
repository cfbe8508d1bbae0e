#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/figures/convergence_figure.hpp"
#include "analysis/statistics/ensemble.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/results/finished_run.hpp"
#include "campaign/studies/convergence_study.hpp"

namespace eerie::studies {

/// A finished run of a study.
using ConvergenceResult = results::RunWithResult<ConvergenceRun>;

/// A CSV table with one line per finished run, and units in the header. A field is empty where
/// there is no such remnant or where it does not spin.
std::string runs_csv(const std::vector<ConvergenceResult>& results);

/// The results of one scheme, case and particle number.
struct ConvergenceCell {
  std::string scheme, case_name;
  std::int64_t particles_per_target = 0;
  statistics::Ensemble b_over_a, c_over_a, m_1, period_h, core_seconds;
  double unsettled = 0,
         p_top3_eer = 0;  ///< fractions of the runs; the EER is among the three largest remnants
  std::string classes;    ///< "hit-and-run 1; perfect-merging 5"
  /// The statistics at ConvergenceStudy::published_at_s, over the runs for which they are known.
  /// There are none without such a time.
  struct AtPublished {
    statistics::Ensemble b_over_a, m_1, period_h;
    double p_top3_eer = 0;
  } at_published = {};
};

/// Looks up the remnants at ConvergenceStudy::published_at_s, where there is such a time and a
/// result lacks them. For a run that ended before, they are those at the end. For others they are
/// those of the last look before that time, in `jobs`; a body that flies between two looks is
/// rigid.
void look_up_published_time(const ConvergenceStudy& study, std::vector<ConvergenceResult>& results,
                            const std::optional<job_folder::JobFolder>& jobs);

/// The ensembles, in the order of the study.
std::vector<ConvergenceCell> cells_of(const ConvergenceStudy& study,
                                      const std::vector<ConvergenceResult>& results);
std::string cells_csv(const std::vector<ConvergenceCell>& cells);

/// A figure of b/a, mass and period of the largest remnant against the particle number. Open marks
/// show the values at ConvergenceStudy::published_at_s where they differ. Nothing where the case
/// has no results.
std::optional<figures::ConvergenceFigure> figure_of(const ConvergenceStudy& study,
                                                    const ConvergenceStudy::Case& one,
                                                    const std::vector<ConvergenceCell>& cells);

}  // namespace eerie::studies
