#pragma once

#include <span>
#include <vector>

#include "campaign/manager/scheduler.hpp"
#include "campaign/slurm/profile.hpp"

namespace eerie::slurm {

/// Core-seconds that a pack of jobs may be expected to take: as the profile says, and little
/// enough for its time limit. 0: no packing.
double pack_core_seconds(const SlurmProfile& profile);

/// Tasks that share an array task, one pack each. Longest first, each task into the fullest pack
/// that has room (best fit); one whose cost is not known gets a pack of its own. The same tasks
/// always give the same packs.
std::vector<std::vector<manager::Task>> packed(std::span<const manager::Task> tasks,
                                               double core_seconds);

}  // namespace eerie::slurm
