#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "campaign/cli/options/options.hpp"

namespace eerie::cli {

/// What `eerie show` draws.
struct PictureArguments {
  std::string panels;                   ///< times, s, with commas; empty: chosen
  std::filesystem::path picture, film;  ///< empty: none
  std::string colour = "body";
  std::optional<double> width;  ///< of what a panel shows, m
  bool cut = false;             ///< along the plane of the orbit
  double frames_per_s = 15;

  bool wanted() const { return !picture.empty() || !film.empty() || !panels.empty(); }
};
void add_pictures(CLI::App& app, PictureArguments& arguments);

/// Draws a job directory's snapshots and says what was drawn:
/// {"panels": [{"requested_s" (null where chosen), "time_s", "file", "remnants_outside"}],
///  "frames", "frame_width_m", "centred_on", "pictures": [file...]}
/// Throws InputError for what cannot be drawn.
Answer draw_pictures(const PictureArguments& arguments, const std::filesystem::path& folder);

}  // namespace eerie::cli
