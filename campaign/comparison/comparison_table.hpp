#pragma once

#include <string>

#include "campaign/comparison/comparison.hpp"
#include "campaign/text/table.hpp"

namespace eerie::comparison {

/// A row per impact, with the means, deviations and numbers of runs of both sides.
text::Table table_of_impacts(const Compared& all);

/// What all of it says, in sentences.
std::string summary(const Compared& all);

}  // namespace eerie::comparison
