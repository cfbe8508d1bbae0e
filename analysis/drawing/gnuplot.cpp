#include "analysis/drawing/gnuplot.hpp"

#include <fmt/format.h>

#include <fstream>

#include "analysis/drawing/portable_svg.hpp"
#include "analysis/drawing/tool.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::drawing {

namespace {
const Tool gnuplot{"gnuplot", "draws the figures", "gnuplot-nox"};

void make_portable(const std::filesystem::path& svg) {
  const std::string text = portable_svg(read_file(svg));
  std::ofstream file(svg, std::ios::binary | std::ios::trunc);
  file << text << std::flush;
  if (!file) throw EnvironmentError(fmt::format("cannot write {}", svg.string()));
}

}  // namespace

Script gnuplot_terminal(const std::filesystem::path& path, double width_pt, double height_pt) {
  const std::string extension = path.extension().string();
  constexpr Literal font = "font 'DejaVu Sans,7' enhanced";
  // The scales make type and lines as large in print as the script asks for.
  if (extension == ".pdf")
    return script("set terminal pdfcairo size {}in,{}in fontscale 0.75 linewidth 2 {}\n",
                  width_pt / 72, height_pt / 72, font);
  if (extension == ".svg")
    return script("set terminal svg size {},{} dynamic background '#ffffff' {}\n", width_pt,
                  height_pt, font);
  constexpr double zoom = 5;  // pixels per point
  if (extension == ".png")
    return script("set terminal pngcairo size {:.0f},{:.0f} fontscale {} linewidth {} {}\n",
                  zoom * width_pt, zoom * height_pt, 0.75 * zoom, zoom, font);
  throw InputError(fmt::format("{}: a figure can be .png, .svg or .pdf", path.string()));
}

void require_figure_file(const std::filesystem::path& path) { gnuplot_terminal(path, 1, 1); }

void run_gnuplot(const Script& script, const std::filesystem::path& path) {
  install_file(path, [&](const std::filesystem::path& temporary) {
    // -d: the user's own ~/.gnuplot must not change our figures.
    const ToolEnd end = run_tool(gnuplot, {"-d", "-"}, script.text(), temporary);
    if (!end.well || std::filesystem::file_size(temporary) == 0)
      throw EnvironmentError(
          fmt::format("gnuplot could not draw {}: {}", path.string(), end.words));
    if (path.extension() == ".svg") make_portable(temporary);
  });
}

}  // namespace eerie::drawing
