#pragma once

#include <string>

#include "solver/particles/state.hpp"

namespace eerie::particles {

/// What came of a time in which nothing changed but places (numerics.rigid_flight).
struct Landing {
  State state;              ///< later; particles in the order that they had
  bool for_impact = false;  ///< bodies are about to meet: a late phase is over
  std::string how;          ///< a sentence for the log
};

}  // namespace eerie::particles
