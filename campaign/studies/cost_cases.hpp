#pragma once

#include <string>
#include <vector>

#include "analysis/figures/matrix_figure.hpp"
#include "campaign/studies/cost_errors.hpp"

namespace eerie::studies {

/// The results of one setting for one impact.
struct CostCell {
  std::size_t setting = 0, case_index = 0;
  statistics::Ensemble b_over_a, c_over_a, m_1, period_h, core_seconds;  ///< of the largest remnant
  double p_top3_eer = 0;  ///< fraction of the runs with an EER among the three largest remnants
  std::string classes;    ///< "hit-and-run 1; perfect-merging 5"
};

/// One cell per setting and case with results, in the order of the study.
std::vector<CostCell> cost_cells(const CostStudy& study, const std::vector<CostResult>& results);

/// A CSV table with one line per setting and case, and units in the header.
std::string cost_cells_csv(const CostStudy& study, const std::vector<CostCell>& cells);

/// A figure with a row per setting and a column per case: b/a and mass of the largest remnant.
figures::MatrixFigure cost_matrix(const CostStudy& study, const std::vector<CostCell>& cells);

}  // namespace eerie::studies
