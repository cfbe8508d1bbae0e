#pragma once

#include <filesystem>
#include <optional>

namespace eerie::process {

/// Where control groups are told of; another place for tests.
struct CgroupPlaces {
  std::filesystem::path of_process = "/proc/self/cgroup";
  std::filesystem::path mounted_at = "/sys/fs/cgroup";
};

/// Cores this process may use: those of its affinity, or fewer where a control group has a quota of
/// processor time (containers, systemd's CPUQuota=), and 1 at least. 2.5 cores of quota are 2: a
/// third worker would only make all of them wait.
std::size_t usable_cores(const CgroupPlaces& places = {});

/// Threads of a single run: OMP_NUM_THREADS where it is set, else usable_cores().
int usable_threads();

/// The smallest quota of the process's control groups and those above, in cores; nothing where
/// there is none. Reads cpu.max (version 2), cpu.cfs_quota_us and cpu.cfs_period_us (version 1).
std::optional<double> cpu_quota(const CgroupPlaces& places = {});

}  // namespace eerie::process
