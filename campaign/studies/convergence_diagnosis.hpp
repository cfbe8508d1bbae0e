#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/figures/convergence_figure.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/studies/convergence_results.hpp"

namespace eerie::studies {

/// What carries the rubble over time, by scheme: the run of the most particles, seed 1; nothing
/// where no history of the case says it.
std::optional<figures::ConvergenceFigure> diagnosis_figure(
    const ConvergenceStudy& study, const ConvergenceStudy::Case& one,
    const std::vector<ConvergenceResult>& results, const job_folder::JobFolder& jobs);

/// Where load and energy are looked at while the bodies are drawn out, s.
inline constexpr double diagnosis_time_s = 1000;

/// The same in numbers, one line per case and scheme: heats and the most elastic energy of shear
/// over the kinetic energy at contact (empty without an energy equation), load and density at
/// diagnosis_time_s, drift of the angular momentum at the end. Units in the header.
std::string diagnosis_csv(const ConvergenceStudy& study,
                          const std::vector<ConvergenceResult>& results,
                          const job_folder::JobFolder& jobs);

}  // namespace eerie::studies
