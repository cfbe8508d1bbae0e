#pragma once

#include <string>

#include "solver/particles/state.hpp"

namespace eerie::particles {

/// The state after a flight of rigid bodies (numerics.rigid_flight), in which only positions
/// changed.
struct Landing {
  State state;              ///< at the later time; particles keep their order
  bool for_impact = false;  ///< true where bodies are about to meet, which ends a late phase
  std::string how;          ///< a sentence for the log
};

}  // namespace eerie::particles
