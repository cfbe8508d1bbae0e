#pragma once

#include <string>

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::proof {

/// Root-mean-square speed of the particles about their mean, m/s.
double rms_speed(const particles::State& state);

/// How a body of rubble keeps at rest under some numerics. It is settled with the defaults and
/// then left alone.
struct RestQuality {
  bool failed = false;
  std::string failure;   ///< kind of the numerical error
  double rms_speed = 0;  ///< largest, over the escape speed, after the first fifth
  double pressure = 0;   ///< mean over 2/5 of the central one: 1 by the virial theorem
};
RestQuality rest_quality(const Scene& scene, double seconds);

}  // namespace eerie::proof
