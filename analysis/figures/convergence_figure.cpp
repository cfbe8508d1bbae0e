#include "analysis/figures/convergence_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "analysis/drawing/gnuplot.hpp"
#include "solver/base/error.hpp"

namespace eerie::figures {

namespace {

using drawing::Literal, drawing::Script, drawing::script, drawing::in_quotes;

constexpr double width_pt = 255, panel_pt = 90, top_pt = 40, bottom_pt = 26;
/// Okabe & Ito's colours, told apart in every common form of colour blindness; with their marks.
constexpr Literal colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#000000"};
constexpr int marks[] = {7, 5, 9, 13, 11, 15}, open_marks[] = {6, 4, 8, 12, 10, 14};

/// 5000 as "5,000".
std::string with_separators(int n) {
  return n < 1000 ? std::to_string(n) : fmt::format("{},{:03}", n / 1000, n % 1000);
}

Script block_name(std::size_t panel, std::size_t series) {
  return script("$p{}s{}", panel, series);
}
Script earlier_name(std::size_t panel, std::size_t series) {
  return block_name(panel, series) + "e";
}
bool has_earlier(const ConvergencePanel& panel, std::size_t series) {
  return series < panel.earlier.size() && !panel.earlier[series].empty();
}

/// Series stand a little beside each other, so that their bars do not cover one another.
double beside(double particles, std::size_t series, std::size_t count) {
  return particles *
         (1 + 0.05 * (static_cast<double>(series) - static_cast<double>(count - 1) / 2));
}

Script data_blocks(const ConvergenceFigure& figure) {
  Script text;
  for (std::size_t p = 0; p < figure.panels.size(); ++p)
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
      text += block_name(p, s) + " << EOD\n";
      for (const ConvergencePoint& x : figure.panels[p].series[s])
        text += figure.over_time ? script("{} {}\n", x.at, x.mean)
                                 : script("{} {} {} {} {}\n", beside(x.at, s, figure.series.size()),
                                          x.mean, x.deviation, x.low, x.high);
      text += "EOD\n";
      if (!has_earlier(figure.panels[p], s)) continue;
      text += earlier_name(p, s) + " << EOD\n";
      for (const ConvergencePoint& x : figure.panels[p].earlier[s])
        text += script("{} {}\n", beside(x.at, s, figure.series.size()), x.mean);
      text += "EOD\n";
    }
  return text;
}

Script ticks(bool labelled) {
  Script list;
  for (const int n : {100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000, 100000})
    list += script("{}{} {}", list.empty() ? Literal("") : Literal(", "),
                   in_quotes(labelled ? with_separators(n) : ""), n);
  return "set xtics (" + list + ")\n";
}

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void include(double value) { low = std::min(low, value), high = std::max(high, value); }
  double span() const { return high - low; }
};

/// The values that a panel shows, with some air.
Script value_range(const ConvergencePanel& panel) {
  Extent values;
  for (const auto& series : panel.series)
    for (const ConvergencePoint& x : series) {
      if (panel.logarithmic && x.mean <= 0) continue;
      values.include(std::min(x.low, x.mean - x.deviation));
      values.include(std::max(x.high, x.mean + x.deviation));
    }
  for (const auto& series : panel.earlier)
    for (const ConvergencePoint& x : series) values.include(x.mean);
  if (panel.published) values.include(*panel.published);
  if (panel.logarithmic)
    return values.high > 0 ? script(
                                 "set logscale y\nset format y '10^{{%T}}'\nset yrange "
                                 "[{}:{}]\n",
                                 values.low / 1.5, values.high * 1.5)
                           : Script("unset logscale y\nset yrange [0:1]\n");
  const double margin = std::max(0.12 * values.span(), 0.05 * std::abs(values.high));
  return script("unset logscale y\nset format y '%g'\nset yrange [{}:{}]\n",
                std::max(0.0, values.low - margin), values.high + margin);
}

/// gnuplot's curves of one series.
Script curve(const Script& block, std::size_t s, bool over_time, const Script& title) {
  if (over_time)
    return script("{} using 1:2 with lines lw 1 lc rgb '{}' {}", block, colours[s], title);
  return script(
      "{0} using 1:2:4:5 with yerrorbars pt {2} ps 0.01 lw 0.5 lc rgb '{1}' notitle, "
      "{0} using 1:2:3 with yerrorbars pt {2} ps 0.45 lw 1.2 lc rgb '{1}' notitle, "
      "{0} using 1:2 with linespoints pt {2} ps 0.45 lw 0.8 lc rgb '{1}' {3}",
      block, colours[s], marks[s], title);
}

Script panel_commands(const ConvergenceFigure& figure, std::size_t p, double height_pt) {
  const ConvergencePanel& panel = figure.panels[p];
  const bool first = p == 0, last = p + 1 == figure.panels.size();
  const double top = height_pt - top_pt - static_cast<double>(p) * panel_pt;
  const double bottom = top - panel_pt + 8;
  // The axis' name as a label: gnuplot would move it with the width of the tick marks.
  Script text = script(
      "set tmargin at screen {}\nset bmargin at screen {}\n"
      "set label 2 {} at screen {},{} center rotate font ',7'\n",
      top / height_pt, bottom / height_pt, in_quotes(panel.label), 6 / width_pt,
      (top + bottom) / 2 / height_pt);
  text += value_range(panel);
  text += figure.over_time ? script("set format x '{}'\n", last ? Literal("%g") : Literal(""))
                           : ticks(last);
  text +=
      last ? script("set xlabel '{}' offset 0,0.6\n",
                    figure.over_time ? Literal("time (1,000 s)") : Literal("particles per target"))
           : Script("unset xlabel\n");
  Script curves;
  const auto add = [&](const Script& more) {
    curves += (curves.empty() ? Literal("") : Literal(", ")) + more;
  };
  if (panel.published)
    add(script("{} with lines dt 2 lw 1 lc rgb '#555555' {}", *panel.published,
               first ? Literal("title 'published'") : Literal("notitle")));
  for (std::size_t s = 0; s < figure.series.size(); ++s)
    if (!panel.series[s].empty())
      add(curve(block_name(p, s), s, figure.over_time,
                first ? script("title {}", in_quotes(figure.series[s])) : Script("notitle")));
  for (std::size_t s = 0; s < figure.series.size(); ++s)
    if (has_earlier(panel, s))
      add(script("{} using 1:2 with points pt {} ps 0.45 lw 0.8 lc rgb '{}' notitle",
                 earlier_name(p, s), open_marks[s], colours[s]));
  if (first && !figure.earlier.empty())
    add(script("NaN with points pt {} ps 0.45 lw 0.8 lc rgb '#555555' title {}", open_marks[0],
               in_quotes(figure.earlier)));
  return curves.empty() ? Script() : text + "plot " + curves + "\nunset label 1\n";
}

double height_of(const ConvergenceFigure& figure) {
  return top_pt + bottom_pt + panel_pt * static_cast<double>(figure.panels.size());
}

}  // namespace

drawing::Script convergence_script(const ConvergenceFigure& figure) {
  Extent abscissa;
  for (const ConvergencePanel& panel : figure.panels)
    for (const auto& series : panel.series)
      for (const ConvergencePoint& x : series) abscissa.include(x.at);
  if (!(abscissa.high > 0))
    throw InputError(fmt::format("{}: there is no result to draw", figure.title));
  const double height = height_of(figure);
  Script text = data_blocks(figure);
  text += figure.over_time ? script("set xrange [0:{}]\n", abscissa.high)
                           : script("set logscale x\nset xrange [{}:{}]\n", abscissa.low / 1.4,
                                    abscissa.high * 1.4);
  text += script(
      "set encoding utf8\nset border lw 0.5\nset bars 0.4\nset pointintervalbox 0\n"
      "set tics scale 0.5\nset lmargin at screen {}\nset rmargin at screen {}\n"
      "set key at screen 0.99,{} top right maxrows 3 samplen 2 font ',6'\n"
      "set label 1 {} at screen {},{} left font ',7'\nset multiplot\n",
      34 / width_pt, 1 - 10 / width_pt, 1 - 12 / height, in_quotes(figure.title), 6 / width_pt,
      1 - 7 / height);
  for (std::size_t p = 0; p < figure.panels.size(); ++p) text += panel_commands(figure, p, height);
  return text + "unset multiplot\n";
}

void draw_convergence(const std::filesystem::path& path, const ConvergenceFigure& figure) {
  drawing::run_gnuplot(
      drawing::gnuplot_terminal(path, width_pt, height_of(figure)) + convergence_script(figure),
      path);
}

}  // namespace eerie::figures
