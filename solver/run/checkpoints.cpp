#include "solver/run/checkpoints.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/version.hpp"

namespace eerie::run {
namespace fs = std::filesystem;

namespace {

/// Why a file is no state that a run of `scene` can go on from; empty where it is one.
std::string obstacle(const io::Snapshot& saved, const Scene& scene) {
  if (scene_hash(saved.scene) != scene_hash(scene)) return "belongs to another scene";
  if (!saved.rates || !saved.restart) return "is no checkpoint";
  if (saved.solver_version != solver_version)
    return fmt::format("is of solver version {}, this is {}", saved.solver_version, solver_version);
  return "";
}

}  // namespace

void install_checkpoint(const fs::path& directory, const io::Snapshot& checkpoint) {
  io::write_snapshot(directory / checkpoint_file, checkpoint, directory / previous_checkpoint_file);
}

std::optional<io::Snapshot> newest_checkpoint(const fs::path& directory, const Scene& scene,
                                              const std::function<void(const std::string&)>& note) {
  for (const std::string name : {final_file, checkpoint_file, previous_checkpoint_file}) {
    const fs::path path = directory / name;
    if (!fs::exists(path)) continue;
    try {
      io::Snapshot saved = io::read_snapshot(path);
      if (const std::string reason = obstacle(saved, scene); !reason.empty()) {
        note(fmt::format("{} {}: passed over", path.string(), reason));
        continue;
      }
      if (name == previous_checkpoint_file) replace_file(path, directory / checkpoint_file);
      return saved;
    } catch (const InputError& error) {
      note(fmt::format("{}: passed over", error.what()));
    }
  }
  return {};
}

}  // namespace eerie::run
