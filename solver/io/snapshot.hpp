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

/// The version of the format. It rises whenever older files can no longer be read.
inline constexpr std::int64_t snapshot_format_version = 4;

/// The content of one HDF5 file in SWIFT's layout (docs/reference/snapshots.md). With `rates` and `restart` it
/// is a checkpoint, from which a run continues with the same bits. Particles are in memory order,
/// and every double keeps its bits.
struct Snapshot {
  Scene scene;
  particles::State state;
  std::vector<double> pressure;  ///< of the equation of state, as the momentum equation uses it, Pa
  std::optional<particles::Rates> rates;
  std::optional<particles::Restart> restart;
  std::string solver_version = eerie::solver_version;  ///< the version that made it
};

/// Seals the file (solver/io/seal.hpp) and installs it atomically. Where `previous` is given, the
/// former file keeps that name. Equal snapshots give equal bytes. Throws EnvironmentError with the
/// reason (disk full, no permission).
void write_snapshot(const std::filesystem::path& path, const Snapshot& snapshot,
                    const std::filesystem::path& previous = {});

/// Reads and checks a file: seal, types, shapes, checksums, finite numbers, ids, densities and the
/// scene inside. Throws InputError, which names file and fault, for a torn, damaged or foreign
/// file. Throws EnvironmentError where the file exists but cannot be read.
Snapshot read_snapshot(const std::filesystem::path& path);

/// Reads the time of a snapshot, s, and checks neither its seal nor its particles. Throws as
/// read_snapshot() does.
double snapshot_time(const std::filesystem::path& path);

}  // namespace eerie::io
