#pragma once

#include <vector>

#include "solver/base/vec3.hpp"

namespace eerie {

/// The mean of at least one vector, summed in their order.
inline Vec3 mean(const std::vector<Vec3>& vectors) {
  Vec3 sum;
  for (const Vec3& one : vectors) sum += one;
  return sum / static_cast<double>(vectors.size());
}

/// Takes the mean off each: then they are about their centre, or do not drift.
inline void take_off_mean(std::vector<Vec3>& vectors) {
  const Vec3 common = mean(vectors);
  for (Vec3& one : vectors) one -= common;
}

}  // namespace eerie
