#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie {

/// One HDF5 file in SWIFT's layout (docs/formats.md): a snapshot, and, when `rates` and
/// `restart` are there, a checkpoint that continues with the same bits.
struct Snapshot {
  Scene scene;
  State state;
  std::vector<double> pressure;  ///< Pa, EOS pressure as the momentum equation uses it
  std::optional<Rates> rates;
  std::optional<Restart> restart;
};

/// Installs the file atomically (temp, fsync, rename). Throws EnvironmentError with the reason.
void write_snapshot(const std::filesystem::path& path, const Snapshot& snapshot);

/// Reads and checks a file: types, shapes, checksums, finite numbers, the scene inside.
/// Throws InputError naming file and fault; a torn or foreign file never passes.
Snapshot read_snapshot(const std::filesystem::path& path);

}  // namespace eerie
