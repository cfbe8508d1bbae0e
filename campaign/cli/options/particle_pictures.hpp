#pragma once

#include <filesystem>
#include <string>

#include "campaign/cli/options/options.hpp"
#include "campaign/run_pictures/picture_files.hpp"

namespace eerie::cli {

/// The pictures that `eerie show` draws.
struct PictureArguments {
  run_pictures::PictureRequest request;
  std::string times;  ///< with commas; empty: chosen
  std::string colour = "body";

  bool wanted() const { return !request.panels.empty() || !request.film.empty() || !times.empty(); }
};
void add_pictures(CLI::App& app, PictureArguments& arguments);

/// Draws the snapshots of a job directory. Answers
/// {"panels": [{"requested_s" (null where chosen), "time_s", "moment", "file",
/// "remnants_outside"}],
///  "frames", "frame_width_m", "centred_on", "pictures": [file...]}.
/// Throws InputError for what cannot be drawn.
Answer draw_pictures(const PictureArguments& arguments, const std::filesystem::path& folder,
                     Format format);

}  // namespace eerie::cli
