#pragma once

#include <string>
#include <vector>

#include "campaign/studies/convergence_results.hpp"
#include "campaign/studies/particles_needed.hpp"

namespace eerie::studies {

/// A study's results as a page in Markdown: for each case its figure (NAME.svg beside the page),
/// its ensembles, what was published, and from which particle number on each scheme is right.
std::string convergence_page(const ConvergenceStudy& study,
                             const std::vector<ConvergenceCell>& cells,
                             const std::vector<ParticlesNeeded>& needed);

}  // namespace eerie::studies
