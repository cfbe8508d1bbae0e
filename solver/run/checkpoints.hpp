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

std::filesystem::path snapshot_path(const std::filesystem::path& directory, long number);

/// A file's state, where it is whole and a run of this very scene by this solver version can go on
/// from it; else `note` is told why not. Nothing, without a note, where there is no such file.
std::optional<io::Snapshot> usable_checkpoint(const std::filesystem::path& path, const Scene& scene,
                                              const std::function<void(const std::string&)>& note);

/// Installs checkpoint.hdf5 and keeps the former one as checkpoint_previous.hdf5. At every instant
/// one of the two is whole: the former one moves on after the new one is on the disk.
void install_checkpoint(const std::filesystem::path& directory, const io::Snapshot& checkpoint);

/// The newest state of this very scene and solver version that can be gone on from: of final,
/// checkpoint and checkpoint_previous, each of which is older than the one before it, the first
/// that is whole. `note` is told why others were passed over. Where it is the previous one, that
/// takes the place of checkpoint.hdf5: the next checkpoint must not push it out for a useless one.
std::optional<io::Snapshot> newest_checkpoint(const std::filesystem::path& directory,
                                              const Scene& scene,
                                              const std::function<void(const std::string&)>& note);

}  // namespace eerie::run
