#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/convergence_figure.hpp"
#include "campaign/job_directory.hpp"
#include "campaign/study.hpp"
#include "db/query.hpp"

namespace eerie {

/// A finished run of a study.
struct StudyResult {
  StudyRun run;
  db::ResultRow row;
  std::vector<db::Remnant> remnants;  ///< from the most massive on
  double core_seconds = 0;            ///< processor time, s
};

/// Those of `runs` that the database has a result of.
std::vector<StudyResult> finished_runs(const db::Connection& connection,
                                       const std::vector<StudyRun>& runs);

/// One line per finished run; units in the header. Empty fields: there is no such remnant, or it
/// does not spin.
std::string runs_csv(const std::vector<StudyResult>& results);

/// What an ensemble says about one quantity.
struct Ensemble {
  std::size_t runs = 0;
  double mean = 0, deviation = 0;  ///< standard deviation of single runs; 0 for one run
  double low = 0, high = 0;
};
Ensemble ensemble(const std::vector<double>& values);

/// The results of one scheme, case and particle number.
struct StudyCell {
  std::string scheme, case_name;
  std::int64_t particles_per_target = 0;
  Ensemble b_over_a, c_over_a, m_1, period_h, core_seconds;
  double unsettled = 0, p_eer = 0;  ///< parts of the runs; EER: any remnant
  std::string classes;              ///< "hit-and-run 1; perfect-merging 5"
};

/// In the order of the study.
std::vector<StudyCell> cells_of(const Study& study, const std::vector<StudyResult>& results);
std::string cells_csv(const std::vector<StudyCell>& cells);

/// b/a, mass and period of the largest remnant against the particle number; nothing where the
/// case has no results.
std::optional<ConvergenceFigure> figure_of(const Study& study, const Study::Case& one,
                                           const std::vector<StudyCell>& cells);

/// What carries the rubble over time, by scheme: the run of the most particles, seed 1; nothing
/// where no history of the case says it.
std::optional<ConvergenceFigure> diagnosis_figure(const Study& study, const Study::Case& one,
                                                  const std::vector<StudyResult>& results,
                                                  const JobFolder& jobs);

}  // namespace eerie
