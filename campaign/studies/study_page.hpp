#pragma once

#include <string>
#include <vector>

#include "campaign/studies/particles_needed.hpp"
#include "campaign/studies/study_results.hpp"

namespace eerie::studies {

/// A study's results as a page in Markdown: for each case its figure (NAME.svg beside the page),
/// its ensembles, what was published, and from which particle number on each scheme is right.
std::string study_page(const Study& study, const std::vector<StudyCell>& cells,
                       const std::vector<Reach>& reaches);

}  // namespace eerie::studies
