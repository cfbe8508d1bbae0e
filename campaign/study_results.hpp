#pragma once

#include <string>
#include <vector>

#include "analysis/convergence_figure.hpp"
#include "campaign/ensemble.hpp"
#include "campaign/finished_run.hpp"
#include "campaign/study.hpp"

namespace eerie {

/// A finished run of a study.
using StudyResult = Finished<StudyRun>;

/// One line per finished run; units in the header. Empty fields: there is no such remnant, or it
/// does not spin.
std::string runs_csv(const std::vector<StudyResult>& results);

/// Fragments lighter than this, over all mass, do not make a run one with an EER: with few
/// particles they would not be seen at all.
inline constexpr double eer_least_mass = 0.05;

/// The results of one scheme, case and particle number.
struct StudyCell {
  std::string scheme, case_name;
  std::int64_t particles_per_target = 0;
  Ensemble b_over_a, c_over_a, m_1, period_h, core_seconds;
  double unsettled = 0, p_eer = 0;  ///< parts of the runs; EER: one of the three largest remnants
  std::string classes;              ///< "hit-and-run 1; perfect-merging 5"
};

/// In the order of the study.
std::vector<StudyCell> cells_of(const Study& study, const std::vector<StudyResult>& results);
std::string cells_csv(const std::vector<StudyCell>& cells);

/// b/a, mass and period of the largest remnant against the particle number; nothing where the
/// case has no results.
std::optional<ConvergenceFigure> figure_of(const Study& study, const Study::Case& one,
                                           const std::vector<StudyCell>& cells);

}  // namespace eerie
