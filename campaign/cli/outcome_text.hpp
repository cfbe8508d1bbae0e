#pragma once

#include <string>

#include "analysis/analysis.hpp"

namespace eerie::cli {

/// An outcome for people: the class, and a table of the remnants.
std::string outcome_text(const Analysis& analysis);

}  // namespace eerie::cli
