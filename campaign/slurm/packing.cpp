#include "campaign/slurm/packing.hpp"

#include <algorithm>
#include <map>

namespace eerie::slurm {
namespace {

/// Start and end of a worker, however small its job.
constexpr double least_core_seconds = 1;

/// Part of the time limit that a pack may be expected to fill: estimates are off by tens of
/// percent.
constexpr double part_of_limit = 0.7;

}  // namespace

double pack_core_seconds(const SlurmProfile& profile) {
  double seconds = 60 * profile.minutes_per_array_task;
  if (profile.time_limit) {
    const double limit =
        static_cast<double>(profile.time_limit->count()) - profile.signal_before_end_s;
    seconds = std::min(seconds, part_of_limit * std::max(0.0, limit));
  }
  return seconds * profile.cpus_per_task;
}

std::vector<std::vector<manager::Task>> packed(std::span<const manager::Task> tasks,
                                               double core_seconds) {
  std::vector<manager::Task> sorted(tasks.begin(), tasks.end());
  std::ranges::stable_sort(sorted, [](const manager::Task& a, const manager::Task& b) {
    if (a.expected_core_seconds != b.expected_core_seconds)
      return a.expected_core_seconds > b.expected_core_seconds;
    return a.job < b.job;
  });
  std::vector<std::vector<manager::Task>> packs;
  std::multimap<double, std::size_t> room;  // what is left -> pack
  for (manager::Task& task : sorted) {
    const bool known = task.expected_core_seconds > 0;
    const double cost = std::max(least_core_seconds, task.expected_core_seconds);
    const auto fullest = known ? room.lower_bound(cost) : room.end();
    if (fullest == room.end()) {
      packs.push_back({std::move(task)});
      if (known) room.emplace(core_seconds - cost, packs.size() - 1);
    } else {
      const auto [left, pack] = *fullest;
      packs[pack].push_back(std::move(task));
      room.erase(fullest);
      room.emplace(left - cost, pack);
    }
  }
  return packs;
}

}  // namespace eerie::slurm
