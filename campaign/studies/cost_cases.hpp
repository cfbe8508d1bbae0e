#pragma once

#include <string>
#include <vector>

#include "analysis/figures/matrix_figure.hpp"
#include "campaign/studies/cost_errors.hpp"

namespace eerie::studies {

/// What one setting makes of one impact.
struct CostCell {
  std::size_t setting = 0, case_index = 0;
  statistics::Ensemble b_over_a, c_over_a, m_1, period_h, core_seconds;  ///< of the largest remnant
  double p_top3_eer = 0;  ///< part of the runs with an EER among the three largest remnants
  std::string classes;    ///< "hit-and-run 1; perfect-merging 5"
};

/// In the order of the study; none where there is no result.
std::vector<CostCell> cost_cells(const CostStudy& study, const std::vector<CostResult>& results);

/// One line per setting and case, units in the header.
std::string cost_cells_csv(const CostStudy& study, const std::vector<CostCell>& cells);

/// A row per setting, a column per case: b/a and mass of the largest remnant.
figures::MatrixFigure cost_matrix(const CostStudy& study, const std::vector<CostCell>& cells);

}  // namespace eerie::studies
