#include "campaign/process/cores.hpp"

#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

namespace eerie::process {
namespace fs = std::filesystem;

namespace {

using Quota = std::optional<double>;

Quota smaller(Quota a, Quota b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

/// "200000 100000", or "max 100000" for no limit.
Quota quota_of_version_2(const fs::path& group) {
  std::ifstream in(group / "cpu.max");
  double quota = 0, period = 0;
  if (in >> quota >> period && quota > 0 && period > 0) return quota / period;
  return std::nullopt;
}

/// A quota of -1 is no limit.
Quota quota_of_version_1(const fs::path& group) {
  std::ifstream quota_file(group / "cpu.cfs_quota_us"), period_file(group / "cpu.cfs_period_us");
  double quota = 0, period = 0;
  if (quota_file >> quota && period_file >> period && quota > 0 && period > 0)
    return quota / period;
  return std::nullopt;
}

/// Of a group and all above it. In a container the path may be the host's: then the mounted folder
/// is the group itself, and parts of the path are missing, which count as no limit.
Quota quota_up(const fs::path& mounted, const fs::path& group, Quota (*quota_of)(const fs::path&)) {
  Quota found = quota_of(mounted);
  fs::path here = mounted;
  for (const fs::path& part : group.relative_path()) {
    here /= part;
    found = smaller(found, quota_of(here));
  }
  return found;
}

bool has_cpu(std::string_view controllers) {
  while (true) {
    const std::size_t comma = controllers.find(',');
    if (controllers.substr(0, comma) == "cpu") return true;
    if (comma == std::string_view::npos) return false;
    controllers.remove_prefix(comma + 1);
  }
}

}  // namespace

std::optional<double> cpu_quota(const CgroupPlaces& places) {
  Quota found;
  std::ifstream in(places.of_process);
  for (std::string line; std::getline(in, line);) {  // "4:cpu,cpuacct:/group", "0::/group"
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path group = line.substr(second + 1);
    if (controllers.empty()) {
      found = smaller(found, quota_up(places.mounted_at, group, quota_of_version_2));
    } else if (has_cpu(controllers)) {
      found = smaller(found, quota_up(places.mounted_at / controllers, group, quota_of_version_1));
      found = smaller(found, quota_up(places.mounted_at / "cpu", group, quota_of_version_1));
    }
  }
  return found;
}

std::size_t usable_cores(const CgroupPlaces& places) {
  const int by_affinity = omp_get_num_procs();  // also where OpenMP has bound this very thread
  const double by_quota = cpu_quota(places).value_or(by_affinity);
  return static_cast<std::size_t>(std::max(1., std::min<double>(by_affinity, by_quota)));
}

int usable_threads() {
  if (std::getenv("OMP_NUM_THREADS") != nullptr) return omp_get_max_threads();
  return static_cast<int>(usable_cores());
}

}  // namespace eerie::process
