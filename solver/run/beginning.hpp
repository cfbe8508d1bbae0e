#pragma once

#include <variant>

#include "solver/run/run.hpp"
#include "solver/step/solver.hpp"

namespace eerie::run {

/// What a run begins with.
struct Beginning {
  step::Solver solver;
  step::Totals first;  ///< at time 0
};

/// The run was stopped before it could begin. Bodies on their way to rest are in the files
/// settling_target.hdf5 and settling_impactor.hdf5, from which the next attempt goes on.
struct NotBegun {
  RunEnd end;         ///< stopped or step_limit
  io::Snapshot last;  ///< bodies that have not settled, on their orbit; or the checkpoint
  long steps = 0;     ///< of settling, by this process
};

/// Makes the bodies of a scene, or goes on from the newest checkpoint in options.directory. Asks
/// options.stop while it packs particles and after every cycle of settling.
std::variant<Beginning, NotBegun> begin(const Scene& scene, const RunOptions& options);

}  // namespace eerie::run
