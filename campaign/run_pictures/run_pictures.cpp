#include "campaign/run_pictures/run_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/drawing/impact_words.hpp"
#include "analysis/remnants/origin.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "solver/base/error.hpp"

namespace eerie::run_pictures {
namespace fs = std::filesystem;

namespace {

/// The scale that `part` of the panels do not exceed.
pictures::ColourScale common_scale(std::vector<pictures::ColourScale> scales, double part) {
  std::ranges::sort(scales, {}, &pictures::ColourScale::top);
  pictures::ColourScale scale =
      scales[static_cast<std::size_t>(part * static_cast<double>(scales.size() - 1))];
  for (const pictures::ColourScale& s : scales) scale.highest = std::max(scale.highest, s.highest);
  return scale;
}

}  // namespace

RunPictures::RunPictures(const fs::path& folder, pictures::ParticleColour colour, bool cut)
    : snapshots_(job_folder::snapshot_files(folder)), scale_{colour, 0, 0}, cut_(cut) {
  if (colour != pictures::ParticleColour::depth) return;
  const fs::path first = job_folder::JobDirectory{folder}.first_snapshot();
  if (!fs::exists(first))
    throw InputError(fmt::format(
        "{}: has no snapshot_0000.hdf5, which says how deep particles lay; give another --colour",
        folder.string()));
  depths_ = remnants::initial_depths(io::read_snapshot(first));
}

void RunPictures::choose_frame(const std::vector<std::size_t>& chosen, std::optional<double> width,
                               double part) {
  layouts_.clear();
  std::vector<pictures::ColourScale> scales;
  for (const std::size_t k : chosen) {
    const io::Snapshot snapshot = io::read_snapshot(snapshots_[k].path);
    layouts_.push_back(pictures::layout_of(snapshot));
    scales.push_back(pictures::colour_scale(scale_.colour, view(snapshot)));
  }
  scale_ = common_scale(std::move(scales), part);
  frame_ = pictures::frame_of(layouts_, width);
}

std::vector<Moment> RunPictures::course() const {
  std::vector<Moment> course;
  for (const job_folder::SnapshotFile& file : snapshots_) {
    const pictures::Layout layout = pictures::layout_of(io::read_snapshot(file.path));
    course.push_back({file.time, layout.bodies.size(), layout.bodies.front().length});
  }
  return course;
}

pictures::PanelsFigure RunPictures::figure(const std::vector<std::size_t>& chosen,
                                           std::size_t first_layout) const {
  pictures::PanelsFigure figure{{}, frame_.width, scale_};
  for (std::size_t p = 0; p < chosen.size(); ++p) {
    const io::Snapshot snapshot = io::read_snapshot(snapshots_[chosen[p]].path);
    const pictures::Layout& layout = layouts_[first_layout + p];
    figure.title = drawing::impact_words(snapshot.scene);
    figure.panels.push_back(
        {snapshot.state.time,
         pictures::panel_image(view(snapshot), frame_, pictures::frame_centre(frame_, layout),
                               scale_, pictures::panel_pixels(chosen.size())),
         pictures::remnants_outside(frame_, layout)});
  }
  return figure;
}

pictures::ParticleView RunPictures::view(const io::Snapshot& snapshot) const {
  return pictures::particle_view(snapshot, scale_.colour, depths_, cut_);
}

}  // namespace eerie::run_pictures
