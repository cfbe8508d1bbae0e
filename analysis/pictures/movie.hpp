#pragma once

#include <filesystem>
#include <functional>

#include "analysis/pictures/panels_figure.hpp"

namespace eerie::pictures {

/// Throws InputError where the extension is neither .mp4 nor .gif, and EnvironmentError where
/// ffmpeg is not installed (with the package to install): before anything is computed.
void require_movie(const std::filesystem::path& path);

/// Draws `frames` figures of one panel each and makes them a film: .mp4 (H.264, for every player)
/// or .gif. Frames are drawn one by one and kept in a temporary folder; the film is installed
/// whole. Throws as require_movie(), InputError without frames, and EnvironmentError with ffmpeg's
/// words.
void make_movie(const std::filesystem::path& path, std::size_t frames, double frames_per_s,
                const std::function<PanelsFigure(std::size_t frame)>& figure);

}  // namespace eerie::pictures
