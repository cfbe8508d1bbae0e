#pragma once

#include <string>

#include "solver/scene/scene.hpp"

namespace eerie::proof {

/// How a body of rubble keeps at rest under some numerics. It is settled with the defaults and
/// then left alone.
struct RestQuality {
  bool failed = false;
  std::string failure;   ///< kind of the numerical error
  double rms_speed = 0;  ///< largest, over the escape speed, after the first fifth
  double pressure = 0;   ///< mean over 2/5 of the central one: 1 by the virial theorem
  double nearest = 0;    ///< mean distance of nearest neighbours at the end, in spacings
  double paired = 0;     ///< fraction of particles with one nearer than half a spacing
};
RestQuality rest_quality(const Scene& scene, double seconds);

}  // namespace eerie::proof
