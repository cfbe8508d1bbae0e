#pragma once

#include "analysis/drawing/script.hpp"

namespace eerie::figures {

/// gnuplot's commands for a linear vertical axis from `low` to `high`, whose ticks stand at round
/// numbers (about five) and all have the same number of decimals.
drawing::Script value_axis(double low, double high);

}  // namespace eerie::figures
