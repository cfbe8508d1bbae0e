#include "analysis/figures/apart.hpp"

#include <algorithm>
#include <cmath>

namespace eerie::figures {

std::vector<double> shifts_apart(std::span<const drawing::Point> marks, double distance,
                                 double most) {
  std::vector<double> shifts(marks.size(), 0);
  const auto is_free = [&](std::size_t k, double shift) {
    for (std::size_t other = 0; other < k; ++other)
      if (std::hypot(marks[k].x + shift - marks[other].x - shifts[other],
                     marks[k].y - marks[other].y) < distance)
        return false;
    return true;
  };
  constexpr double step = 0.5;
  for (std::size_t k = 0; k < marks.size(); ++k)
    for (double shift = 0; shift <= most; shift += step) {
      const double side = is_free(k, shift) ? 1 : is_free(k, -shift) ? -1 : 0;
      if (side == 0) continue;
      shifts[k] = side * shift;
      break;
    }
  return shifts;
}

}  // namespace eerie::figures
