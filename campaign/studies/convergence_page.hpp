#pragma once

#include <string>
#include <vector>

#include "campaign/studies/convergence_results.hpp"
#include "campaign/studies/particles_needed.hpp"

namespace eerie::studies {

/// The results of a study as a page in Markdown. Each case has its figure (NAME.svg beside the
/// page), its ensembles, the published numbers, and the particle number from which on each scheme
/// is right.
std::string convergence_page(const ConvergenceStudy& study,
                             const std::vector<ConvergenceCell>& cells,
                             const std::vector<ParticlesNeeded>& needed);

}  // namespace eerie::studies
