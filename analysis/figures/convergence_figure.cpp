#include "analysis/figures/convergence_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/grouped.hpp"
#include "analysis/drawing/key.hpp"
#include "analysis/figures/value_axis.hpp"
#include "solver/base/error.hpp"

namespace eerie::figures {

namespace {

using drawing::Literal, drawing::Script, drawing::script, drawing::in_quotes;

constexpr double width_pt = 255, panel_pt = 90, title_pt = 13, bottom_pt = 26, margin_pt = 6;
/// Okabe & Ito's colours, told apart in every common form of colour blindness; with their marks.
constexpr Literal colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#000000"};
constexpr int marks[] = {7, 5, 9, 13, 11, 15}, open_marks[] = {6, 4, 8, 12, 10, 14};

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
        text += figure.over_time
                    ? script("{} {}\n", x.at, x.mean)
                    : script("{} {:.10g} {:.10g} {:.10g}\n", beside(x.at, s, figure.series.size()),
                             x.mean, x.mean - x.deviation, x.mean + x.deviation);
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
                   in_quotes(labelled ? drawing::grouped(n) : ""), n);
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
      values.include(x.mean - x.deviation);
      values.include(x.mean + x.deviation);
    }
  for (const auto& series : panel.earlier)
    for (const ConvergencePoint& x : series) values.include(x.mean);
  if (panel.published) values.include(*panel.published);
  if (panel.logarithmic)
    return values.high > 0
               ? script(
                     "set logscale y\nset ytics autofreq\nset format y '10^{{%T}}'\nset yrange "
                     "[{}:{}]\n",
                     values.low / 1.5, values.high * 1.5)
               : Script("unset logscale y\nset yrange [0:1]\n");
  const double margin = std::max(0.12 * values.span(), 0.05 * std::abs(values.high));
  return "unset logscale y\n" +
         value_axis(std::max(0.0, values.low - margin), values.high + margin);
}

/// The look of a series, in the panels and in the legend.
Script line_of(std::size_t s, bool over_time) {
  return script("lw {} lc rgb '{}'", over_time ? 1.0 : 0.8, colours[s]);
}
Script point_of(std::size_t s) { return script("pt {} ps 0.45 lc rgb '{}'", marks[s], colours[s]); }
Script open_point_of(std::size_t s) {
  return script("pt {} ps 0.45 lw 0.8 lc rgb '{}'", open_marks[s], colours[s]);
}
constexpr Literal published_line = "dt 2 lw 1 lc rgb '#555555'";

/// gnuplot's curves of one series. Bars are vectors: gnuplot would put white discs behind marks
/// with bars.
Script curve(const Script& block, std::size_t s, bool over_time) {
  if (over_time) return script("{} using 1:2 with lines {}", block, line_of(s, over_time));
  return script(
      "{0} using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '{1}', "
      "{0} using 1:2 with lines {2}, {0} using 1:2 with points {3}",
      block, colours[s], line_of(s, over_time), point_of(s));
}

bool has_points(const ConvergenceFigure& figure, std::size_t s) {
  return std::ranges::any_of(figure.panels,
                             [&](const ConvergencePanel& p) { return !p.series[s].empty(); });
}

bool has_bars(const ConvergenceFigure& figure) {
  for (const ConvergencePanel& panel : figure.panels)
    for (const auto& series : panel.series)
      if (std::ranges::any_of(series, [](const ConvergencePoint& x) { return x.deviation > 0; }))
        return !figure.over_time;
  return false;
}

drawing::Key key_of(const ConvergenceFigure& figure) {
  std::vector<drawing::KeyEntry> entries;
  for (std::size_t s = 0; s < figure.series.size(); ++s)
    if (has_points(figure, s))
      entries.push_back({in_quotes(figure.series[s]), line_of(s, figure.over_time),
                         figure.over_time ? Script() : point_of(s)});
  if (std::ranges::any_of(figure.panels,
                          [](const ConvergencePanel& p) { return p.published.has_value(); }))
    entries.push_back({in_quotes("published"), Script(published_line)});
  if (!figure.earlier.empty()) entries.push_back({in_quotes(figure.earlier), {}, open_point_of(0)});
  if (has_bars(figure)) entries.push_back({in_quotes("bars: standard deviation of one run")});
  return {std::move(entries), width_pt - 2 * margin_pt};
}

double top_of(const ConvergenceFigure& figure) { return title_pt + key_of(figure).height_pt() + 6; }

/// Title and legend, once for all panels.
Script head(const ConvergenceFigure& figure, double height_pt) {
  drawing::Canvas canvas(width_pt, height_pt);
  const drawing::Quoted title = in_quotes(figure.title);
  canvas.text({margin_pt, height_pt - 7}, title,
              {.size = drawing::size_that_fits(title, width_pt - 2 * margin_pt, 7),
               .colour = {},
               .align = drawing::Align::left});
  key_of(figure).draw(canvas, {margin_pt, height_pt - title_pt});
  return canvas.commands();
}

Script panel_commands(const ConvergenceFigure& figure, std::size_t p, double height_pt) {
  const ConvergencePanel& panel = figure.panels[p];
  const bool first = p == 0, last = p + 1 == figure.panels.size();
  const double top = height_pt - top_of(figure) - static_cast<double>(p) * panel_pt;
  const double bottom = top - panel_pt + 8;
  // The axis' name as a label: gnuplot would move it with the width of the tick marks.
  Script text = script(
      "set tmargin at screen {}\nset bmargin at screen {}\n"
      "set label {} at screen {},{} center rotate font ',{:.2f}'\n",
      top / height_pt, bottom / height_pt, in_quotes(panel.label), 6 / width_pt,
      (top + bottom) / 2 / height_pt,
      drawing::size_that_fits(in_quotes(panel.label), top - bottom, 7));
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
  if (panel.published) add(script("{} with lines {}", *panel.published, published_line));
  for (std::size_t s = 0; s < figure.series.size(); ++s)
    if (!panel.series[s].empty()) add(curve(block_name(p, s), s, figure.over_time));
  for (std::size_t s = 0; s < figure.series.size(); ++s)
    if (has_earlier(panel, s))
      add(script("{} using 1:2 with points {}", earlier_name(p, s), open_point_of(s)));
  if (curves.empty()) return {};
  return text + (first ? head(figure, height_pt) : Script()) + "plot " + curves +
         "\nunset label\nunset arrow\n";
}

double height_of(const ConvergenceFigure& figure) {
  return top_of(figure) + bottom_pt + panel_pt * static_cast<double>(figure.panels.size());
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
      "set encoding utf8\nset border lw 0.5\nunset key\n"
      "set tics scale 0.5\nset lmargin at screen {}\nset rmargin at screen {}\nset multiplot\n",
      34 / width_pt, 1 - 10 / width_pt);
  for (std::size_t p = 0; p < figure.panels.size(); ++p) text += panel_commands(figure, p, height);
  return text + "unset multiplot\n";
}

void draw_convergence(const std::filesystem::path& path, const ConvergenceFigure& figure) {
  drawing::run_gnuplot(
      drawing::gnuplot_terminal(path, width_pt, height_of(figure)) + convergence_script(figure),
      path);
}

}  // namespace eerie::figures
