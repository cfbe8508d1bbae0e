#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "solver/io/snapshot.hpp"
#include "solver/particles/state.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::run {

/// Bodies at rest, kept in a folder for every run whose scene makes the same ones. To make two
/// bodies takes an eighth of a run of 1,000 particles, and all impacts of a grid share theirs. A
/// run has the same bits with and without the folder, which may be removed at any time.
class KeptBodies {
 public:
  using Note = std::function<void(const std::string&)>;

  /// An empty path keeps nothing. The folder is made when there is something to keep.
  KeptBodies(std::filesystem::path folder, Note note);

  /// The solver's state of a body at rest; nothing where there is none. To ask where keeps(). A
  /// file that is damaged, or that belongs to another body, is passed over with a note.
  std::optional<io::Snapshot> find(const Scene& scene, particles::Body body) const;

  /// Moves a checkpoint of a body that has come to rest into the folder. A run writes it in its own
  /// folder first: whoever is killed there leaves nothing half written among the bodies of others.
  /// Where the move is not possible, it notes why.
  void keep(const Scene& scene, particles::Body body, const std::filesystem::path& at_rest) const;

  bool keeps() const { return !folder_.empty(); }

 private:
  std::filesystem::path file_of(particles::Body body, const std::string& hash) const;

  std::filesystem::path folder_;
  Note note_;
};

}  // namespace eerie::run
