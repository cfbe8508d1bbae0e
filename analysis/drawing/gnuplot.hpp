#pragma once

#include <filesystem>

#include "analysis/drawing/script.hpp"

namespace eerie::drawing {

/// The terminal line for a figure of the given size (PostScript points, as printed) in the format
/// that the extension of `path` names: .png (at 360 dpi), .svg or .pdf. Font sizes in the script
/// are points as printed. Throws InputError for any other extension.
Script gnuplot_terminal(const std::filesystem::path& path, double width_pt, double height_pt);

/// Runs gnuplot on a script and installs what it draws atomically at `path`. No shell is involved
/// and the script need not know the path. Throws EnvironmentError: gnuplot is missing (with the
/// package to install), refused the script (with its words), or drew nothing.
void run_gnuplot(const Script& script, const std::filesystem::path& path);

}  // namespace eerie::drawing
