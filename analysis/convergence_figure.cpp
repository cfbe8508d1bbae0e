#include "analysis/convergence_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "analysis/gnuplot.hpp"
#include "solver/base/error.hpp"

namespace eerie {

namespace {

constexpr double width_pt = 255, panel_pt = 90, top_pt = 30, bottom_pt = 26;
/// Okabe & Ito's colours, told apart in every common form of colour blindness; with their marks.
constexpr const char* colours[] = {"#0072b2", "#d55e00", "#009e73",
                                   "#cc79a7", "#56b4e9", "#000000"};
constexpr int marks[] = {7, 5, 9, 13, 11, 6};

/// 5000 as "5,000".
std::string with_separators(int n) {
  return n < 1000 ? std::to_string(n) : fmt::format("{},{:03}", n / 1000, n % 1000);
}

std::string block_name(std::size_t panel, std::size_t series) {
  return fmt::format("$p{}s{}", panel, series);
}

/// Series stand a little beside each other, so that their bars do not cover one another.
double beside(double particles, std::size_t series, std::size_t count) {
  return particles *
         (1 + 0.05 * (static_cast<double>(series) - static_cast<double>(count - 1) / 2));
}

std::string data_blocks(const ConvergenceFigure& figure) {
  std::string text;
  for (std::size_t p = 0; p < figure.panels.size(); ++p)
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
      text += block_name(p, s) + " << EOD\n";
      for (const ConvergencePoint& x : figure.panels[p].series[s])
        text += fmt::format("{} {} {} {} {}\n", beside(x.particles, s, figure.series.size()),
                            x.mean, x.deviation, x.low, x.high);
      text += "EOD\n";
    }
  return text;
}

std::string ticks(bool labelled) {
  std::string list;
  for (const int n : {100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000, 100000})
    list += fmt::format(R"({}"{}" {})", list.empty() ? "" : ", ",
                        labelled ? with_separators(n) : "", n);
  return "set xtics (" + list + ")\n";
}

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void include(double value) { low = std::min(low, value), high = std::max(high, value); }
  double span() const { return high - low; }
};

std::string panel_commands(const ConvergenceFigure& figure, std::size_t p, double height_pt,
                           const Extent& particles) {
  const ConvergencePanel& panel = figure.panels[p];
  const bool last = p + 1 == figure.panels.size();
  const double top = height_pt - top_pt - static_cast<double>(p) * panel_pt;
  Extent values;
  for (const auto& series : panel.series)
    for (const ConvergencePoint& x : series) {
      values.include(std::min(x.low, x.mean - x.deviation));
      values.include(std::max(x.high, x.mean + x.deviation));
    }
  if (panel.published) values.include(*panel.published);
  const double margin = std::max(0.12 * values.span(), 0.05 * std::abs(values.high));
  std::string text = fmt::format(
      "set tmargin at screen {}\nset bmargin at screen {}\nset yrange [{}:{}]\n"
      "set ylabel '{}' offset 0.8,0\n",
      top / height_pt, (top - panel_pt + 8) / height_pt, std::max(0.0, values.low - margin),
      values.high + margin, panel.label);
  text += ticks(last);
  text += last ? "set xlabel 'particles per target' offset 0,0.6\n" : "unset xlabel\n";
  std::string curves;
  if (panel.published)
    curves += fmt::format("{} with lines dt 2 lw 1 lc rgb '#555555' {}", *panel.published,
                          p == 0 ? "title 'published'" : "notitle");
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    if (panel.series[s].empty()) continue;
    const std::string block = block_name(p, s);
    curves += fmt::format(
        "{0}{1} using 1:2:4:5 with yerrorbars pt {3} ps 0.01 lw 0.5 lc rgb '{2}' notitle, "
        "{1} using 1:2:3 with yerrorbars pt {3} ps 0.45 lw 1.2 lc rgb '{2}' notitle, "
        "{1} using 1:2 with linespoints pt {3} ps 0.45 lw 0.8 lc rgb '{2}' {4}",
        curves.empty() ? "" : ", ", block, colours[s], marks[s],
        p == 0 ? fmt::format("title '{}'", figure.series[s]) : "notitle");
  }
  return text + fmt::format("set xrange [{}:{}]\nplot {}\n", particles.low / 1.4,
                            particles.high * 1.4, curves);
}

}  // namespace

std::string convergence_script(const ConvergenceFigure& figure) {
  Extent particles;
  for (const ConvergencePanel& panel : figure.panels)
    for (const auto& series : panel.series)
      for (const ConvergencePoint& x : series) particles.include(x.particles);
  if (!(particles.high > 0))
    throw InputError(fmt::format("{}: there is no result to draw", figure.title));
  const double height = top_pt + bottom_pt + panel_pt * static_cast<double>(figure.panels.size());
  std::string text = data_blocks(figure);
  text += fmt::format(
      "set encoding utf8\nset border lw 0.5\nset logscale x\nset bars 0.4\nset pointintervalbox "
      "0\nset tics scale 0.5\n"
      "set lmargin at screen {}\nset rmargin at screen {}\n"
      "set key at screen 0.99,{} top right maxrows 2 samplen 2 font ',6'\n"
      "set label 1 '{}' at screen {},{} left font ',7'\nset multiplot\n",
      34 / width_pt, 1 - 10 / width_pt, 1 - 12 / height, figure.title, 6 / width_pt,
      1 - 7 / height);
  for (std::size_t p = 0; p < figure.panels.size(); ++p)
    text += panel_commands(figure, p, height, particles);
  return text + "unset multiplot\n";
}

void draw_convergence(const std::filesystem::path& path, const ConvergenceFigure& figure) {
  const double height = top_pt + bottom_pt + panel_pt * static_cast<double>(figure.panels.size());
  run_gnuplot(gnuplot_terminal(path, width_pt, height) + convergence_script(figure), path);
}

}  // namespace eerie
