#pragma once

#include <span>
#include <vector>

#include "analysis/drawing/canvas.hpp"

namespace eerie::figures {

/// How far each mark moves along x, in points, so that no two lie nearer than `distance`. The first
/// marks stay, later ones move as little as they must, to either side. A mark for which nothing
/// within `most` is free stays too.
std::vector<double> shifts_apart(std::span<const drawing::Point> marks, double distance,
                                 double most);

}  // namespace eerie::figures
