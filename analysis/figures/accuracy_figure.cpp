#include "analysis/figures/accuracy_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/drawing/gnuplot.hpp"
#include "solver/base/error.hpp"

namespace eerie::figures {

namespace {

using drawing::Literal, drawing::Script, drawing::script, drawing::in_quotes;

constexpr double width_pt = 510, panel_width_pt = 185, panel_height_pt = 130, left_pt = 38,
                 top_pt = 16, between_pt = 34, between_columns_pt = 12, legend_pt = 118;
/// Okabe & Ito's colours, told apart in every common form of colour blindness; once they are used
/// up the marks change.
constexpr Literal colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};
constexpr int marks[] = {7, 4, 9, 10, 5, 6};
constexpr int default_mark = 3;
constexpr Literal black = "#000000";

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

/// "cost height low high" of one point in one panel.
Script row(const AccuracyPoint& point, std::size_t panel) {
  const AccuracyPoint::Error& e = point.errors[panel];
  return script("{} {} {} {}\n", point.core_seconds, height(e),
                std::max(height(e) - e.noise, height(e) / 3), height(e) + e.noise);
}

Script block(std::size_t panel, std::size_t series) { return script("$p{}s{}", panel, series); }

Script rings(std::size_t panel) { return script("$p{}rings", panel); }

bool has_rings(const AccuracyFigure& figure) {
  bool any = false;
  each_point(figure, [&](const AccuracyPoint& x) { any = any || !x.whole; });
  return any;
}

bool has_names(const AccuracyFigure& figure) {
  bool any = false;
  each_point(figure, [&](const AccuracyPoint& x) { any = any || !x.name.empty(); });
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
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
      text += block(p, s) + " << EOD\n";
      for (const AccuracyPoint& x : figure.series[s].points) text += row(x, p);
      text += "EOD\n";
      // The line of a knob passes through the default.
      std::vector<const AccuracyPoint*> line = {&standard};
      for (const AccuracyPoint& x : figure.series[s].points) line.push_back(&x);
      std::ranges::sort(line, {}, &AccuracyPoint::core_seconds);
      text += block(p, s) + "line << EOD\n";
      for (const AccuracyPoint* x : line) text += row(*x, p);
      text += "EOD\n";
    }
    text += rings(p) + " << EOD\n";
    each_point(figure, [&](const AccuracyPoint& x) {
      if (!x.whole) text += row(x, p);
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
  each_point(figure, [&](const AccuracyPoint& x) {
    if (!x.name.empty())
      text += script("set label {} at {},{} right offset -0.2,-0.6 font ',6.5'\n",
                     in_quotes(x.name), x.core_seconds, height(x.errors[p]));
  });
  return text;
}

Script panel_commands(const AccuracyFigure& figure, std::size_t p, double height_pt) {
  const std::size_t line_of_panel = p / 2;
  const auto column = static_cast<double>(p % 2), line = static_cast<double>(line_of_panel);
  const double left = left_pt + column * (panel_width_pt / 1.3 + between_columns_pt + left_pt);
  const double right = left + panel_width_pt / 1.3;
  const double top = height_pt - top_pt - line * (panel_height_pt + between_pt);
  Script text = script(
      "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\n"
      "set bmargin at screen {}\n",
      left / width_pt, right / width_pt, top / height_pt, (top - panel_height_pt) / height_pt);
  Extent errors;
  each_point(figure, [&](const AccuracyPoint& x) { errors.include(height(x.errors[p])); });
  text += script("set yrange [{}:{}]\nset ylabel {} offset 0.9,0\n", errors.low / 2,
                 errors.high * 2, in_quotes("error of ") + in_quotes(figure.panels[p]));
  Script curves = script("$p{}frontier using 1:2 with steps lw 3 lc rgb '#dddddd' notitle", p);
  for (const std::size_t s : drawing_order(figure)) {
    const Look look = look_of(figure, s);
    curves += script(
        ", {0}line using 1:2 with lines lw 0.4 lc rgb '{1}' notitle"
        ", {0} using 1:2:3:4 with yerrorbars pt {2} ps 0.01 lw 0.3 lc rgb '{1}' notitle"
        ", {0} using 1:2 with points pt {2} ps {3} lw 1.2 lc rgb '{1}' notitle",
        block(p, s), look.colour, look.mark, look.size);
  }
  if (has_rings(figure))
    curves +=
        script(", {} using 1:2 with points pt 6 ps 1 lw 0.6 lc rgb '{}' notitle", rings(p), black);
  return text + names(figure, p) + "plot " + curves + "\nunset label\n";
}

/// The legend beside the panels: a plot of nothing, as high as the page.
Script legend_commands(const AccuracyFigure& figure) {
  Script curves("1/0 with lines lw 3 lc rgb '#dddddd' title 'frontier'");
  if (has_rings(figure))
    curves +=
        script(", 1/0 with points pt 6 ps 1 lw 0.6 lc rgb '{}' title 'some impacts only'", black);
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    const Look look = look_of(figure, s);
    curves += script(", 1/0 with points pt {} ps {} lw 1.2 lc rgb '{}' title {}", look.mark,
                     look.size, look.colour, in_quotes(figure.series[s].name));
  }
  return script(
      "set lmargin at screen {}\nset rmargin at screen 1\nset tmargin at screen 1\n"
      "set bmargin at screen 0\nunset border\nunset tics\nunset xlabel\nunset ylabel\n"
      "set key inside left top Left reverse samplen 1 spacing 1.1 font ',7'\nplot {}\n",
      1 - legend_pt / width_pt, curves);
}

double height_of(const AccuracyFigure& figure) {
  const std::size_t lines = (figure.panels.size() + 1) / 2;
  return top_pt + static_cast<double>(lines) * (panel_height_pt + between_pt);
}

}  // namespace

drawing::Script accuracy_script(const AccuracyFigure& figure) {
  Extent cost;
  each_point(figure, [&](const AccuracyPoint& x) { cost.include(x.core_seconds); });
  const double height = height_of(figure);
  Script text = data_blocks(figure);
  text += script(
      "set encoding utf8\nset border lw 0.5\nset bars 0\nset tics scale 0.5 font ',7'\n"
      "set logscale xy\nset xrange [{}:{}]\nset xtics ({})\nset ytics ({})\n"
      "set xlabel 'cost of an impact (core-seconds)' offset 0,0.7 font ',7'\n"
      "set ylabel font ',7'\n"
      "unset key\n"
      "set multiplot\n",
      cost.low / (has_names(figure) ? 2 : 1.2), cost.high * 1.2,
      ticks(0.1, 1e6, cost.high / cost.low), ticks(1e-5, 10, 1));
  for (std::size_t p = 0; p < figure.panels.size(); ++p) text += panel_commands(figure, p, height);
  return text + legend_commands(figure) + "unset multiplot\n";
}

void draw_accuracy(const std::filesystem::path& path, const AccuracyFigure& figure) {
  drawing::run_gnuplot(
      drawing::gnuplot_terminal(path, width_pt, height_of(figure)) + accuracy_script(figure), path);
}

}  // namespace eerie::figures
