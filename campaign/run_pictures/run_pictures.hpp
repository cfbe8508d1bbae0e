#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/pictures/panels_figure.hpp"
#include "analysis/pictures/particle_view.hpp"
#include "campaign/job_folder/snapshot_files.hpp"
#include "solver/io/snapshot.hpp"

namespace eerie::run_pictures {

/// Pictures of the particles of one run, with a frame and a scale of colours that all share.
class RunPictures {
 public:
  /// Throws InputError where the folder has no snapshot, or not the first for colours of depth.
  RunPictures(const std::filesystem::path& folder, pictures::ParticleColour colour, bool cut);

  const std::vector<job_folder::SnapshotFile>& series() const { return series_; }
  const pictures::Frame& frame() const { return frame_; }
  const pictures::Layout& layout(std::size_t panel) const { return layouts_[panel]; }

  /// Looks at the chosen snapshots once, for a frame (`width` in m, else as they need) that serves
  /// them all and a scale that serves `part` of them: the instant of the impact must not darken the
  /// rest of a film.
  void choose_frame(const std::vector<std::size_t>& chosen, std::optional<double> width,
                    double part);

  /// A panel for each of the chosen snapshots; the first has the layout `first_layout`.
  pictures::PanelsFigure figure(const std::vector<std::size_t>& chosen,
                                std::size_t first_layout = 0) const;

 private:
  pictures::ParticleView view(const io::Snapshot& snapshot) const;

  std::vector<job_folder::SnapshotFile> series_;
  std::vector<double> depths_;
  std::vector<pictures::Layout> layouts_;
  pictures::ColourScale scale_;
  bool cut_;
  pictures::Frame frame_;
};

}  // namespace eerie::run_pictures
