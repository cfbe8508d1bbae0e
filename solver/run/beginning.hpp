#pragma once

#include <variant>

#include "solver/run/run.hpp"
#include "solver/step/solver.hpp"

namespace eerie::run {

/// The solver with which a run begins.
struct Beginning {
  step::Solver solver;
  step::Totals first;      ///< at time 0
  bool has_ended = false;  ///< an earlier attempt reached its end with this state
};

/// The state of a run that was stopped before it could begin. The files settling_target.hdf5 and
/// settling_impactor.hdf5 hold the bodies on their way to rest, and the next attempt continues from
/// them.
struct NotBegun {
  RunEnd end;         ///< stopped or step_limit
  io::Snapshot last;  ///< the bodies, not yet settled, on their orbit; or the checkpoint
  long steps = 0;     ///< of settling, made by this process
};

/// Makes the bodies of a scene, or continues from the newest checkpoint in options.directory. Calls
/// options.stop while it packs particles and after every cycle of settling.
std::variant<Beginning, NotBegun> begin(const Scene& scene, const RunOptions& options);

}  // namespace eerie::run
