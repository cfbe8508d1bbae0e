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

/// One line per finished run; units in the header. Empty fields: there is no such remnant, or it
/// does not spin.
std::string runs_csv(const std::vector<ConvergenceResult>& results);

/// The results of one scheme, case and particle number.
struct ConvergenceCell {
  std::string scheme, case_name;
  std::int64_t particles_per_target = 0;
  statistics::Ensemble b_over_a, c_over_a, m_1, period_h, core_seconds;
  double unsettled = 0,
         p_top3_eer = 0;  ///< parts of the runs; EER: one of the three largest remnants
  std::string classes;    ///< "hit-and-run 1; perfect-merging 5"
  /// The same when what is published was measured, of the runs of which that is known; without a
  /// ConvergenceStudy::published_at_s of none.
  struct AtPublished {
    statistics::Ensemble b_over_a, m_1, period_h;
    double p_top3_eer = 0;
  } at_published = {};
};

/// Looks up the remnants at ConvergenceStudy::published_at_s, where there is such a time and a
/// result does not say them of that time yet: of runs that ended before, those of the end; of
/// others, those in the last look before, in `jobs`. A body that flies between two looks is rigid.
void look_up_published_time(const ConvergenceStudy& study, std::vector<ConvergenceResult>& results,
                            const std::optional<job_folder::JobFolder>& jobs);

/// In the order of the study.
std::vector<ConvergenceCell> cells_of(const ConvergenceStudy& study,
                                      const std::vector<ConvergenceResult>& results);
std::string cells_csv(const std::vector<ConvergenceCell>& cells);

/// b/a, mass and period of the largest remnant against the particle number, and as open marks
/// where they were others at ConvergenceStudy::published_at_s; nothing where the case has no
/// results.
std::optional<figures::ConvergenceFigure> figure_of(const ConvergenceStudy& study,
                                                    const ConvergenceStudy::Case& one,
                                                    const std::vector<ConvergenceCell>& cells);

}  // namespace eerie::studies
