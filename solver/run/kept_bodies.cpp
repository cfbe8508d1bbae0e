#include "solver/run/kept_bodies.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/files/folders.hpp"
#include "solver/initial/bodies.hpp"
#include "solver/run/checkpoints.hpp"

namespace eerie::run {
namespace fs = std::filesystem;

KeptBodies::KeptBodies(fs::path folder, Note note)
    : folder_(std::move(folder)), note_(std::move(note)) {}

std::optional<io::Snapshot> KeptBodies::find(const Scene& scene, particles::Body body) const {
  const std::string wanted = initial::body_hash(scene, body);
  const fs::path file = file_of(body, wanted);
  auto kept = usable_checkpoint(
      file, [&](const Scene& of) { return initial::body_hash(of, body) == wanted; }, note_);
  if (kept) note_(fmt::format("{}: taken at rest", file.string()));
  return kept;
}

void KeptBodies::keep(const Scene& scene, particles::Body body, const fs::path& at_rest) const {
  try {
    make_folders(folder_);
    replace_file(at_rest, file_of(body, initial::body_hash(scene, body)));
  } catch (const EnvironmentError& error) {
    note_(
        fmt::format("the {} is not kept for other runs: {}", initial::name_of(body), error.what()));
  }
}

fs::path KeptBodies::file_of(particles::Body body, const std::string& hash) const {
  return folder_ / fmt::format("{}_{}.hdf5", initial::name_of(body), hash.substr(0, 16));
}

}  // namespace eerie::run
