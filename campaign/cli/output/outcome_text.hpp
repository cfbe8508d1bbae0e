#pragma once

#include <string>

#include "analysis/remnants/analysis.hpp"

namespace eerie::cli {

/// An outcome for people: the class, and a table of the remnants.
std::string outcome_text(const remnants::Analysis& analysis);

}  // namespace eerie::cli
