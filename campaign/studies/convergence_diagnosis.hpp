#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/figures/convergence_figure.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/studies/convergence_results.hpp"

namespace eerie::studies {

/// A figure of what carries the rubble over time, for each scheme. It uses the run with the most
/// particles and seed 1. Nothing where no history of the case has the numbers.
std::optional<figures::ConvergenceFigure> diagnosis_figure(
    const ConvergenceStudy& study, const ConvergenceStudy::Case& one,
    const std::vector<ConvergenceResult>& results, const job_folder::JobFolder& jobs);

/// The time, s, at which load and energy are read, while the bodies are being stretched.
inline constexpr double diagnosis_time_s = 1000;

/// A CSV table with one line per case and scheme, and units in the header. It has heats and the
/// largest elastic energy of shear, in units of the kinetic energy at contact (empty without an
/// energy equation); load and density at diagnosis_time_s; and the drift of the angular momentum at
/// the end.
std::string diagnosis_csv(const ConvergenceStudy& study,
                          const std::vector<ConvergenceResult>& results,
                          const job_folder::JobFolder& jobs);

}  // namespace eerie::studies
