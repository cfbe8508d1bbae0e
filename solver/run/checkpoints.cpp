#include "solver/run/checkpoints.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/version.hpp"

namespace eerie::run {
namespace fs = std::filesystem;

namespace {

/// Why a file is no state that a run can go on from; empty where it is one.
std::string obstacle(const io::Snapshot& saved, const std::function<bool(const Scene&)>& belongs) {
  if (!belongs(saved.scene)) return "belongs to another scene";
  if (!saved.rates || !saved.restart) return "is no checkpoint";
  if (saved.solver_version != solver_version)
    return fmt::format("is of solver version {}, this is {}", saved.solver_version, solver_version);
  return "";
}

}  // namespace

fs::path snapshot_path(const fs::path& directory, long number) {
  return directory / fmt::format("snapshot_{:04d}.hdf5", number);
}

std::optional<io::Snapshot> usable_checkpoint(const fs::path& path, const Scene& scene,
                                              const std::function<void(const std::string&)>& note) {
  const auto same = [&](const Scene& saved) { return scene_hash(saved) == scene_hash(scene); };
  return usable_checkpoint(path, same, note);
}

std::optional<io::Snapshot> usable_checkpoint(const fs::path& path,
                                              const std::function<bool(const Scene&)>& belongs,
                                              const std::function<void(const std::string&)>& note) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::nullopt;
  try {
    io::Snapshot saved = io::read_snapshot(path);
    const std::string reason = obstacle(saved, belongs);
    if (reason.empty()) return saved;
    note(fmt::format("{} {}: passed over", path.string(), reason));
  } catch (const InputError& error) {
    note(fmt::format("{}: passed over", error.what()));
  }
  return std::nullopt;
}

void install_checkpoint(const fs::path& directory, const io::Snapshot& checkpoint) {
  io::write_snapshot(directory / checkpoint_file, checkpoint, directory / previous_checkpoint_file);
}

std::optional<Saved> newest_checkpoint(const fs::path& directory, const Scene& scene,
                                       const std::function<void(const std::string&)>& note) {
  for (const std::string name : {final_file, checkpoint_file, previous_checkpoint_file}) {
    auto saved = usable_checkpoint(directory / name, scene, note);
    if (!saved) continue;
    if (name == previous_checkpoint_file)
      replace_file(directory / name, directory / checkpoint_file);
    return Saved{*std::move(saved), name == final_file};
  }
  return {};
}

}  // namespace eerie::run
