#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/pictures/panels_figure.hpp"
#include "analysis/pictures/particle_view.hpp"
#include "campaign/job_folder/snapshot_files.hpp"
#include "campaign/run_pictures/telling_moments.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::run_pictures {

/// Pictures of the particles of one run, which share a frame and a scale of colours.
class RunPictures {
 public:
  /// Throws InputError where the folder has no snapshot, or where colours of depth lack the first
  /// one.
  RunPictures(const std::filesystem::path& folder, pictures::ParticleColour colour, bool cut);

  const std::vector<job_folder::SnapshotFile>& snapshots() const { return snapshots_; }
  const pictures::Frame& frame() const { return frame_; }
  const pictures::Layout& layout(std::size_t panel) const { return layouts_[panel]; }

  /// Chooses a frame that suits all chosen snapshots (`width` in m, or as wide as they need) and a
  /// scale of colours that suits the fraction `part` of them. So the moment of impact does not
  /// darken the rest of a film.
  void choose_frame(const std::vector<std::size_t>& chosen, std::optional<double> width,
                    double part);

  /// The course of the impact, a moment for each snapshot. It reads all of them.
  std::vector<Moment> course() const;

  /// A figure with a panel for each chosen snapshot, and the impact in its title. The first panel
  /// has the layout `first_layout`.
  pictures::PanelsFigure figure(const std::vector<std::size_t>& chosen,
                                std::size_t first_layout = 0) const;

 private:
  pictures::ParticleView view(const io::Snapshot& snapshot) const;

  std::vector<job_folder::SnapshotFile> snapshots_;
  std::vector<double> depths_;
  std::vector<pictures::Layout> layouts_;
  pictures::ColourScale scale_;
  bool cut_;
  pictures::Frame frame_;
};

}  // namespace eerie::run_pictures
