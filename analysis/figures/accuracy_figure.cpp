#include "analysis/figures/accuracy_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/key.hpp"
#include "analysis/figures/apart.hpp"
#include "solver/base/error.hpp"

namespace eerie::figures {

namespace {

using drawing::Literal, drawing::Script, drawing::script, drawing::in_quotes;

constexpr double width_pt = 510, panel_width_pt = 205, panel_height_pt = 130, left_pt = 40,
                 between_pt = 34, between_columns_pt = 46, margin_pt = 6, title_pt = 14;
/// Okabe & Ito's colours, told apart in every common form of colour blindness; once they are used
/// up the marks change.
constexpr Literal colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};
constexpr int marks[] = {7, 4, 9, 10, 5, 6};
constexpr int default_mark = 3;
constexpr Literal black = "#000000";
constexpr Literal frontier = "lw 3 lc rgb '#dddddd'", ring = "pt 6 ps 1 lw 0.6 lc rgb '#000000'";
constexpr double most_shift_pt = 14;
constexpr double mark_pt = 4.5;  ///< the distance at which two marks are told apart

/// Where the point stands: a difference far below its noise says nothing.
double height(const AccuracyPoint::Error& e) { return std::max({e.error, e.noise / 10, 1e-5}); }

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  void include(double value) { low = std::min(low, value), high = std::max(high, value); }
};

template <class Visit>
void each_point(const AccuracyFigure& figure, Visit&& visit) {
  for (const AccuracySeries& series : figure.series)
    for (const AccuracyPoint& point : series.points) visit(point);
}

const AccuracyPoint& default_point(const AccuracyFigure& figure) {
  const auto found = std::ranges::find(figure.series, true, &AccuracySeries::is_default);
  if (found == figure.series.end() || found->points.empty())
    throw InputError(fmt::format("{}: the default has no result to draw", figure.title));
  return found->points.front();
}

bool has_names(const AccuracyFigure& figure) {
  bool any = false;
  each_point(figure, [&](const AccuracyPoint& x) { any = any || !x.name.empty(); });
  return any;
}

struct Extents {
  Extent cost, error;  ///< of the axes
};

Extents extents_of(const AccuracyFigure& figure, std::size_t panel) {
  Extents all;
  each_point(figure, [&](const AccuracyPoint& x) {
    all.cost.include(x.core_seconds), all.error.include(height(x.errors[panel]));
  });
  // Names stand left of their points.
  all.cost.low /= has_names(figure) ? 2 : 1.2, all.cost.high *= 1.2;
  all.error.low /= 2, all.error.high *= 2;
  return all;
}

/// The costs at which marks stand in a panel: their own, or beside where another mark lies there.
using MarkCosts = std::map<const AccuracyPoint*, double>;
MarkCosts mark_costs(const AccuracyFigure& figure, std::size_t panel) {
  const Extents axes = extents_of(figure, panel);
  const double x_unit = panel_width_pt / std::log(axes.cost.high / axes.cost.low),
               y_unit = panel_height_pt / std::log(axes.error.high / axes.error.low);
  std::vector<const AccuracyPoint*> points;
  std::vector<drawing::Point> places;
  for (const bool standard : {true, false})
    for (const AccuracySeries& series : figure.series)
      for (const AccuracyPoint& x : series.points) {
        if (series.is_default != standard) continue;
        points.push_back(&x);
        places.push_back({x_unit * std::log(x.core_seconds / axes.cost.low),
                          y_unit * std::log(height(x.errors[panel]) / axes.error.low)});
      }
  const std::vector<double> shifts = shifts_apart(places, mark_pt, most_shift_pt);
  MarkCosts costs;
  for (std::size_t k = 0; k < points.size(); ++k)
    costs[points[k]] = points[k]->core_seconds * std::exp(shifts[k] / x_unit);
  return costs;
}

/// "cost height low high" of one point in one panel.
Script row(const AccuracyPoint& point, std::size_t panel, const MarkCosts& costs) {
  const AccuracyPoint::Error& e = point.errors[panel];
  return script("{:.10g} {} {} {}\n", costs.at(&point), height(e),
                std::max(height(e) - e.noise, height(e) / 3), height(e) + e.noise);
}

Script block(std::size_t panel, std::size_t series) { return script("$p{}s{}", panel, series); }

Script rings(std::size_t panel) { return script("$p{}rings", panel); }

bool has_rings(const AccuracyFigure& figure) {
  bool any = false;
  each_point(figure, [&](const AccuracyPoint& x) { any = any || !x.whole; });
  return any;
}

/// 1, 2 and 5 times the powers of ten in between; 1 and 3 times where the axis spans more of them.
Script ticks(double low, double high, double span) {
  constexpr double few_decades = 200;
  const std::vector<int> steps = span <= few_decades ? std::vector{1, 2, 5} : std::vector{1, 3};
  Script list;
  for (double decade = low; decade <= high * 1.001; decade *= 10)
    for (const int step : steps)
      list +=
          script("{0}\"{1:g}\" {1:g}", list.empty() ? Literal("") : Literal(", "), step * decade);
  return list;
}

Script data_blocks(const AccuracyFigure& figure) {
  const AccuracyPoint& standard = default_point(figure);
  Script text;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const MarkCosts costs = mark_costs(figure, p);
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
      text += block(p, s) + " << EOD\n";
      for (const AccuracyPoint& x : figure.series[s].points) text += row(x, p, costs);
      text += "EOD\n";
      // The line of a knob passes through the default.
      std::vector<const AccuracyPoint*> line = {&standard};
      for (const AccuracyPoint& x : figure.series[s].points) line.push_back(&x);
      std::ranges::sort(line, {}, [&](const AccuracyPoint* x) { return costs.at(x); });
      text += block(p, s) + "line << EOD\n";
      for (const AccuracyPoint* x : line) text += row(*x, p, costs);
      text += "EOD\n";
    }
    text += rings(p) + " << EOD\n";
    each_point(figure, [&](const AccuracyPoint& x) {
      if (!x.whole) text += row(x, p, costs);
    });
    text += "EOD\n";
    std::vector<std::pair<double, double>> all;
    each_point(figure, [&](const AccuracyPoint& x) {
      if (x.whole) all.emplace_back(x.core_seconds, height(x.errors[p]));
    });
    std::ranges::sort(all);
    text += script("$p{}frontier << EOD\n", p);
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [cost, error] : all)
      if (error < best) {
        text += script("{} {}\n", cost, error);
        best = error;
      }
    text += script("{} {}\nEOD\n", all.back().first * 1.3, best);
  }
  return text;
}

/// How a series is drawn.
struct Look {
  Literal colour;
  int mark;
  double size;
};
Look look_of(const AccuracyFigure& figure, std::size_t s) {
  if (figure.series[s].is_default) return {black, default_mark, 1.1};
  return {colours[s % std::size(colours)], marks[(s / std::size(colours) + s) % std::size(marks)],
          0.55};
}

Script mark_of(const Look& look) {
  return script("pt {} ps {} lw 1.2 lc rgb '{}'", look.mark, look.size, look.colour);
}

/// The default lies on top.
std::vector<std::size_t> drawing_order(const AccuracyFigure& figure) {
  std::vector<std::size_t> order;
  for (const bool standard : {false, true})
    for (std::size_t s = 0; s < figure.series.size(); ++s)
      if (figure.series[s].is_default == standard) order.push_back(s);
  return order;
}

/// Errors fall with cost: below and left of a point there is room for its name.
Script names(const AccuracyFigure& figure, std::size_t p) {
  Script text;
  const MarkCosts costs = mark_costs(figure, p);
  each_point(figure, [&](const AccuracyPoint& x) {
    if (!x.name.empty())
      text += script("set label {} at {},{} right offset -0.2,-0.6 front font ',6.5'\n",
                     in_quotes(x.name), costs.at(&x), height(x.errors[p]));
  });
  return text;
}

/// Title and legend, once for all panels.
drawing::Key key_of(const AccuracyFigure& figure) {
  std::vector<drawing::KeyEntry> entries;
  for (std::size_t s = 0; s < figure.series.size(); ++s)
    entries.push_back({in_quotes(figure.series[s].name), {}, mark_of(look_of(figure, s))});
  if (has_rings(figure)) entries.push_back({in_quotes("some impacts only"), {}, Script(ring)});
  entries.push_back({in_quotes("frontier: nothing is cheaper and better"), Script(frontier)});
  entries.push_back({in_quotes("bars: noise of the seeds")});
  entries.push_back({in_quotes("marks that would hide each other stand side by side")});
  return {std::move(entries), width_pt - 2 * margin_pt};
}

double top_of(const AccuracyFigure& figure) { return title_pt + key_of(figure).height_pt() + 8; }

double height_of(const AccuracyFigure& figure) {
  const std::size_t lines = (figure.panels.size() + 1) / 2;
  return top_of(figure) + static_cast<double>(lines) * (panel_height_pt + between_pt);
}

Script head(const AccuracyFigure& figure, double height_pt) {
  drawing::Canvas canvas(width_pt, height_pt);
  canvas.text(
      {margin_pt, height_pt - 7}, in_quotes(figure.title),
      {.size = drawing::size_that_fits(in_quotes(figure.title), width_pt - 2 * margin_pt, 7.5),
       .colour = {},
       .align = drawing::Align::left});
  key_of(figure).draw(canvas, {margin_pt, height_pt - title_pt});
  return canvas.commands();
}

Script panel_commands(const AccuracyFigure& figure, std::size_t p, double height_pt) {
  const std::size_t line_of_panel = p / 2;
  const auto column = static_cast<double>(p % 2), line = static_cast<double>(line_of_panel);
  const double left = left_pt + column * (panel_width_pt + between_columns_pt);
  const double top = height_pt - top_of(figure) - line * (panel_height_pt + between_pt);
  Script text = script(
      "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\n"
      "set bmargin at screen {}\n",
      left / width_pt, (left + panel_width_pt) / width_pt, top / height_pt,
      (top - panel_height_pt) / height_pt);
  const Extents axes = extents_of(figure, p);
  text += script("set xrange [{}:{}]\nset yrange [{}:{}]\nset ylabel {} offset 0.9,0\n",
                 axes.cost.low, axes.cost.high, axes.error.low, axes.error.high,
                 in_quotes("error of ") + in_quotes(figure.panels[p]));
  Script curves = script("$p{}frontier using 1:2 with steps {}", p, frontier);
  // Bars are vectors: gnuplot would put white discs behind marks with bars.
  for (const std::size_t s : drawing_order(figure))
    curves += script(
        ", {0}line using 1:2 with lines lw 0.4 lc rgb '{1}'"
        ", {0} using 1:3:(0):($4-$3) with vectors nohead lw 0.3 lc rgb '{1}'"
        ", {0} using 1:2 with points {2}",
        block(p, s), look_of(figure, s).colour, mark_of(look_of(figure, s)));
  if (has_rings(figure)) curves += script(", {} using 1:2 with points {}", rings(p), ring);
  return text + names(figure, p) + (p == 0 ? head(figure, height_pt) : Script()) + "plot " +
         curves + "\nunset label\nunset arrow\n";
}

}  // namespace

drawing::Script accuracy_script(const AccuracyFigure& figure) {
  const double height = height_of(figure);
  const Extents axes = extents_of(figure, 0);
  Script text = data_blocks(figure);
  text += script(
      "set encoding utf8\nset border lw 0.5\nset tics scale 0.5 font ',7'\n"
      "set logscale xy\nset xtics ({})\nset ytics ({})\n"
      "set xlabel 'cost of an impact (core-seconds)' offset 0,0.7 font ',7'\n"
      "set ylabel font ',7'\nunset key\nset multiplot\n",
      ticks(0.1, 1e6, axes.cost.high / axes.cost.low), ticks(1e-5, 1e5, 1));
  for (std::size_t p = 0; p < figure.panels.size(); ++p) text += panel_commands(figure, p, height);
  return text + "unset multiplot\n";
}

void draw_accuracy(const std::filesystem::path& path, const AccuracyFigure& figure) {
  drawing::run_gnuplot(
      drawing::gnuplot_terminal(path, width_pt, height_of(figure)) + accuracy_script(figure), path);
}

}  // namespace eerie::figures
