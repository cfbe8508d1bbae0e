#include "solver/material/grady_kipp.hpp"

namespace eerie::material {

Flaws GradyKipp::deal(std::size_t particles, double V, Random& random) const {
  std::vector<std::vector<double>> of(particles);
  const auto n = static_cast<double>(particles);
  std::size_t without = particles;
  for (double j = 1; without > 0; ++j) {
    const auto id = std::min(static_cast<std::size_t>(random.uniform() * n), particles - 1);
    if (of[id].empty()) --without;
    of[id].push_back(std::pow(j / (k_.k_per_m3 * V), 1 / k_.m));
  }
  Flaws flaws;
  flaws.begin.push_back(0);
  for (const std::vector<double>& own : of) {
    flaws.strain.insert(flaws.strain.end(), own.begin(), own.end());
    flaws.begin.push_back(static_cast<std::uint32_t>(flaws.strain.size()));
  }
  return flaws;
}

}  // namespace eerie::material
