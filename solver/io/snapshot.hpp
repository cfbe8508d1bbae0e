#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/version.hpp"
#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::io {

/// The per-particle fields that the physics of a scene needs.
inline particles::OptionalFields optional_fields(const Scene& scene) {
  return {has_energy(scene), has_fracture(scene), is_shear_free(scene), feels_viscosity(scene)};
}

/// Raised whenever a file written before can no longer be read.
inline constexpr std::int64_t snapshot_format_version = 4;

/// One HDF5 file in SWIFT's layout (docs/reference/snapshots.md): a snapshot, and, when `rates` and
/// `restart` are there, a checkpoint that continues with the same bits. Particles are in memory
/// order, and every double comes back as it was.
struct Snapshot {
  Scene scene;
  particles::State state;
  std::vector<double> pressure;  ///< Pa, EOS pressure as the momentum equation uses it
  std::optional<particles::Rates> rates;
  std::optional<particles::Restart> restart;
  std::string solver_version = eerie::solver_version;  ///< that made it
};

/// Installs the file atomically (temp, fsync, rename), sealed (solver/io/seal.hpp); a former file
/// goes on as `previous` where that is given. Equal snapshots give equal bytes. Throws
/// EnvironmentError with the reason (disk full, no permission).
void write_snapshot(const std::filesystem::path& path, const Snapshot& snapshot,
                    const std::filesystem::path& previous = {});

/// Reads and checks a file: seal, types, shapes, checksums, finite numbers, ids, densities, the
/// scene inside. Throws InputError naming file and fault: a torn, damaged or foreign file never
/// passes. Throws EnvironmentError where the file is there but cannot be read.
Snapshot read_snapshot(const std::filesystem::path& path);

/// The time of a snapshot, s, and nothing else of it: neither its seal nor its particles are looked
/// at. Throws as read_snapshot() does.
double snapshot_time(const std::filesystem::path& path);

}  // namespace eerie::io
