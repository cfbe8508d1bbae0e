#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::serve {

/// The snapshots of a job directory in order of time: {"snapshots": [{"name", "time_s"}]}.
nlohmann::json snapshots_json(const job_folder::JobDirectory& directory);

/// The most particles of a picture.
inline constexpr std::size_t most_particles = 200'000;

/// One snapshot of a job directory in the form that the page draws, little-endian:
///   4 bytes "eer1", uint32 length of the head; the head as JSON, padded with spaces to a multiple
///   of four; float32 positions relative to the centre of mass (3 n: x y z of each particle, m);
///   float32 depth of origin (m), speed relative to its clump (m/s), pressure (Pa), n each; bytes
///   body (0 target, 1 impactor) and remnant (its rank, 0: debris, 255: a later one), n each.
/// The head is {"n", "of" (before thinning), "time_s", "radius_m", "ranges": {"depth", "speed",
/// "pressure": [low, high]}, "remnants": [{"rank", "particles", "x", "axes", "lengths"}],
/// "colours": {"bodies", "stops"}}. More than `most` particles are thinned evenly by id. `name` is
/// one of snapshots_json(). Throws InputError for another name.
std::string particles(const job_folder::JobDirectory& directory, const std::string& name,
                      std::size_t most = most_particles);

}  // namespace eerie::serve
