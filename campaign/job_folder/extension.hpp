#pragma once

#include "campaign/job_folder/job_directory.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::job_folder {

/// The scene with which a finished run goes on to `until_s` (simulated time): end.time_s is then
/// that, or end.latest_s where the run had to end while remnants were going to meet. Throws
/// InputError with the reason where the directory has no result, where the run is that far
/// already, where it had settled and so would end at the same moment again, and where it has kept
/// no state that a run with a later end would have had too.
Scene extended_scene(const JobDirectory& finished, const Scene& scene, double until_s);

/// Whether a finished run has kept a state to go on from. extended_scene() asks for more.
bool may_be_extended(const JobDirectory& finished);

/// Makes the directory of the run that goes on with the finished one: the state before the end
/// began to matter as its checkpoint, and the history, looks and snapshots until then. All files
/// are those of a run of `later` that was stopped there, so its end has the same bits as that of
/// one which had the later end from its start. Does nothing where that run has begun. Returns the
/// time of the state, s.
double make_extension(const JobDirectory& finished, const JobDirectory& longer, const Scene& later);

}  // namespace eerie::job_folder
