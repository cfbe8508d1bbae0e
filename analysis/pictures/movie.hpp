#pragma once

#include <filesystem>
#include <functional>

#include "analysis/pictures/panels_figure.hpp"

namespace eerie::pictures {

/// Throws InputError where the extension is neither .mp4 nor .gif, and EnvironmentError where
/// ffmpeg is not installed (with the package to install). Call it before anything is computed.
void require_movie(const std::filesystem::path& path);

/// Draws `frames` figures of one panel each and makes a film of them: .mp4 (H.264, for every
/// player) or .gif. It draws frames one by one into a temporary folder and installs the film
/// atomically. Throws as require_movie() does, InputError without frames, and EnvironmentError with
/// ffmpeg's words.
void make_movie(const std::filesystem::path& path, std::size_t frames, double frames_per_s,
                const std::function<PanelsFigure(std::size_t frame)>& figure);

}  // namespace eerie::pictures
