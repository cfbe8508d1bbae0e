#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "analysis/pictures/particle_view.hpp"
#include "campaign/text/table.hpp"

namespace eerie::run_pictures {

/// What to draw of a run.
struct PictureRequest {
  std::filesystem::path panels, film;  ///< files; empty: not drawn
  std::vector<double> times = {};      ///< of the panels, s; empty: five telling moments
  pictures::ParticleColour colour = pictures::ParticleColour::body;
  std::optional<double> width = {};  ///< of a panel, m; nothing: as wide as the remnants need
  bool cut = false;                  ///< removes the half in front of the plane of the orbit
  double frames_per_s = 15;          ///< of the film
};

/// Throws InputError for files of other formats, and EnvironmentError without the program that
/// makes films. Call it before anything is read or written.
void require_drawable(const PictureRequest& request);

/// The pictures that were drawn.
struct DrawnPictures {
  text::Table
      panels;  ///< times asked for and taken, what happens, files, remnants outside the frame
  std::size_t frames = 0;  ///< of the film
  pictures::Frame frame;   ///< of the panels, or of the film alone
};

/// Hears before each frame of a film how many are drawn, and of how many.
using OnFrame = std::function<void(std::size_t drawn, std::size_t all)>;

/// Draws the snapshots in `folder` into files whose folders exist. Throws InputError for what
/// cannot be drawn, and EnvironmentError where a program or the disk fails.
DrawnPictures draw(const PictureRequest& request, const std::filesystem::path& folder,
                   const OnFrame& on_frame = {});

}  // namespace eerie::run_pictures
