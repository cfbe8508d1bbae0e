#pragma once

#include <filesystem>

#include "analysis/drawing/script.hpp"

namespace eerie::drawing {

/// The terminal line for a figure of the given size (PostScript points, as printed). The extension
/// of `path` names the format: .png (at 360 dpi), .svg or .pdf. Font sizes in the script are points
/// as printed. Throws InputError for any other extension.
Script gnuplot_terminal(const std::filesystem::path& path, double width_pt, double height_pt);

/// Throws that InputError before any work is done.
void require_figure_file(const std::filesystem::path& path);

/// Runs gnuplot on a script, without a shell, and installs the figure atomically at `path`. Throws
/// EnvironmentError where gnuplot is missing (with the package to install), refuses the script
/// (with its words) or draws nothing.
void run_gnuplot(const Script& script, const std::filesystem::path& path);

}  // namespace eerie::drawing
