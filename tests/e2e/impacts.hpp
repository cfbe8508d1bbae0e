#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/manager/scheduler.hpp"
#include "solver/base/file.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::test {

/// Impacts of small bodies, each in its job directory under `folder`, as a manager would leave
/// them to workers; each takes about a second per 10,000 s.
inline std::vector<manager::Task> impacts(const std::filesystem::path& folder, int count,
                                          double end_time_s) {
  std::vector<manager::Task> tasks;
  for (int k = 0; k < count; ++k) {
    const Scene scene =
        parse_scene({{"numerics", {{"particles_per_target", 100}, {"seed", k + 1}}},
                     {"output", {{"history_interval_s", 5000}, {"checkpoint_interval_s", 0.1}}},
                     {"end", {{"time_s", end_time_s}}}});
    const job_folder::JobDirectory directory{folder / scene_hash(scene).substr(0, 16)};
    std::filesystem::create_directories(directory.path);
    install_text(directory.scene(), to_json(scene).dump() + "\n");
    tasks.push_back({k, directory, 1});
  }
  return tasks;
}

}  // namespace eerie::test
