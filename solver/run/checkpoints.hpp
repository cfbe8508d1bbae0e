#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "solver/io/snapshot.hpp"

namespace eerie::run {

inline constexpr const char* checkpoint_file = "checkpoint.hdf5";
inline constexpr const char* previous_checkpoint_file = "checkpoint_previous.hdf5";
inline constexpr const char* final_file = "final.hdf5";
inline constexpr const char* before_end_file = "before_end.hdf5";

std::filesystem::path snapshot_path(const std::filesystem::path& directory, long number);

/// Reads a checkpoint if it is whole and belongs to this scene and this solver version. Otherwise
/// it returns nothing and calls `note` with the reason; a missing file makes no note.
std::optional<io::Snapshot> usable_checkpoint(const std::filesystem::path& path, const Scene& scene,
                                              const std::function<void(const std::string&)>& note);

/// The same where `belongs` tells of a saved scene whether its state may be used.
std::optional<io::Snapshot> usable_checkpoint(const std::filesystem::path& path,
                                              const std::function<bool(const Scene&)>& belongs,
                                              const std::function<void(const std::string&)>& note);

/// Installs checkpoint.hdf5 and keeps the former one as checkpoint_previous.hdf5. One of the two is
/// whole at every instant, since the former one is renamed after the new one is on the disk.
void install_checkpoint(const std::filesystem::path& directory, const io::Snapshot& checkpoint);

struct Saved {
  io::Snapshot state;
  bool is_final;  ///< the run had ended with it
};
/// The newest state from which a run of this scene by this solver version can continue: the first
/// whole file of final, checkpoint and checkpoint_previous. `note` gets the reason for each file
/// that is skipped. Where checkpoint_previous is taken, it replaces checkpoint.hdf5, so that the
/// next checkpoint does not keep a useless file as the previous one.
std::optional<Saved> newest_checkpoint(const std::filesystem::path& directory, const Scene& scene,
                                       const std::function<void(const std::string&)>& note);

}  // namespace eerie::run
