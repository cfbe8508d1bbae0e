#pragma once

#include <span>
#include <vector>

#include "campaign/manager/scheduler.hpp"
#include "campaign/slurm/profile.hpp"

namespace eerie::slurm {

/// The core-seconds that a pack of jobs may take: what the profile says, limited by its time limit.
/// 0 means no packing.
double pack_core_seconds(const SlurmProfile& profile);

/// Packs the tasks; each pack becomes an array task. The longest task comes first, and each goes
/// into the fullest pack that still has room (best fit). A task of unknown cost gets its own pack.
/// The same tasks always give the same packs.
std::vector<std::vector<manager::Task>> packed(std::span<const manager::Task> tasks,
                                               double core_seconds);

}  // namespace eerie::slurm
