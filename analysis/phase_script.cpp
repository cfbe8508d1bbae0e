#include "analysis/phase_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/canvas.hpp"
#include "analysis/map_axis.hpp"
#include "analysis/outcome.hpp"
#include "analysis/phase_legend.hpp"
#include "analysis/remnants.hpp"
#include "solver/base/constants.hpp"

namespace eerie {

namespace {

// All in points; 255 points are 9 cm.
constexpr double page_width = 255, map_height = 150;
constexpr double left = 32, right = 36, above = 36, below = 24;
constexpr double value_size = 6, tick_size = 6.5;

/// The map's frame on the page and the way from data to page.
struct Frame {
  MapAxis v, theta;
  Area area;

  double x(double v_cm_per_s) const {
    return area.low.x +
           area.width() * (v_cm_per_s - v.edges.front()) / (v.edges.back() - v.edges.front());
  }
  double y(double theta_deg) const {
    return area.low.y + area.height() * (theta_deg - theta.edges.front()) /
                            (theta.edges.back() - theta.edges.front());
  }
  Area cell(const PhaseCell& c) const {
    const std::size_t i = v.index(c.v_imp_cm_per_s), j = theta.index(c.theta_imp_deg);
    return {{x(v.edges[i]), y(theta.edges[j])}, {x(v.edges[i + 1]), y(theta.edges[j + 1])}};
  }
};

Frame frame_of(const PhaseDiagram& diagram, double bottom) {
  std::vector<double> v, theta;
  for (const PhaseCell& cell : diagram.cells) {
    v.push_back(cell.v_imp_cm_per_s);
    theta.push_back(cell.theta_imp_deg);
  }
  return {
      map_axis(v), map_axis(theta), {{left, bottom}, {page_width - right, bottom + map_height}}};
}

/// "0.24", or ".24" where the cell is narrow.
std::string value_text(double b_over_a, double cell_width) {
  std::string text = fmt::format("{:.2f}", b_over_a);
  if (text_width(text, value_size) + 2.5 > cell_width) {
    text = text.starts_with("0") ? text.substr(1) : text.substr(0, 3);
  }
  return text;
}

std::string_view class_letter(const std::string& outcome) {
  return std::ranges::find(outcome_names, outcome, &OutcomeName::name)->short_name;
}

/// Words on a patch of the cell's colour, so that the curve does not run through them.
void cell_text(Canvas& canvas, Point at, const std::string& words, double size, Colour fill,
               bool bold) {
  const double half_width = text_width(words, size) / 2 - 0.5, half_height = 0.42 * size;
  canvas.patch({{at.x - half_width, at.y - half_height}, {at.x + half_width, at.y + half_height}},
               fill);
  canvas.text(at, words, {.size = size, .colour = text_colour(fill), .bold = bold});
}

void draw_result(Canvas& canvas, const Area& area, const PhaseCell& cell) {
  const Colour fill = b_over_a_colour(cell.b_over_a);
  const bool unsettled = cell.state == CellState::unsettled;
  canvas.fill(area, fill);
  if (unsettled) map_mark::unsettled(canvas, area);
  if (cell.eer && cell.b_over_a >= eer_max_b_over_a) map_mark::smaller_eer(canvas, area);
  const Point middle = area.centre();
  const double lift = std::min(area.height() / 5, 4.5);
  cell_text(canvas, {middle.x, middle.y + lift}, value_text(cell.b_over_a, area.width()),
            value_size, fill, false);
  cell_text(canvas, {middle.x, middle.y - lift},
            fmt::format("{}{}{}", class_letter(cell.outcome), unsettled ? "?" : "",
                        cell.fidelity.empty() ? "" : " " + map_mark::basis(cell)),
            map_mark::letter_size, fill, true);
}

void draw_cells(Canvas& canvas, const PhaseDiagram& diagram, const Frame& frame) {
  for (const PhaseCell& cell : diagram.cells) {
    const Area area = frame.cell(cell);
    switch (cell.state) {
      case CellState::done:
      case CellState::unsettled:
        draw_result(canvas, area, cell);
        break;
      case CellState::failed:
        map_mark::failed(canvas, area);
        break;
      case CellState::pending:
        map_mark::pending(canvas, area);
        break;
    }
    canvas.outline(area, {255, 255, 255}, 0.5);
    if (cell.in_doubt) map_mark::in_doubt(canvas, area);
  }
}

/// gnuplot's list of ticks at the given data values: ("15" 15, ...), some left out where their
/// words would touch.
std::string tick_list(const std::vector<double>& values, double points_per_unit, double unit = 1) {
  std::string list;
  double free_from = -1e300;
  for (const double value : values) {
    const std::string words = fmt::format("{:g}", value);
    const double at = value * unit * points_per_unit;
    const double half = text_width(words, tick_size) / 2;
    const bool fits = at - half >= free_from;
    if (fits) free_from = at + half + 1.5;
    list += fmt::format("{}\"{}\" {}", list.empty() ? "" : ", ", fits ? words : "", value * unit);
  }
  return "(" + list + ")";
}

void draw_titles(Canvas& canvas, const PhaseDiagram& diagram, const Frame& frame, double height) {
  const Area& a = frame.area;
  const Point middle = a.centre();
  // The spaces beside subscripts do not break: SVG viewers drop ordinary ones.
  const Style across{.size = 7, .colour = map_mark::ink};
  Style upwards = across;
  upwards.upwards = true;
  canvas.text(
      {middle.x, height - 7},
      fmt::format("q = {:g},  φ_d\u00a0= {:g}°{}", diagram.q, diagram.phi_d_deg,
                  diagram.particles_per_target == 0
                      ? ""
                      : fmt::format(",  {} particles per target", diagram.particles_per_target)),
      across);
  canvas.text({middle.x, a.low.y - 17}, "v_{imp}\u00a0(cm/s)", across);
  canvas.text({a.low.x - 25, middle.y}, "θ_{imp}\u00a0(deg)", upwards);
  canvas.text({a.high.x + 31, middle.y}, "b/a of the largest remnant", upwards);
  if (diagram.v_esc_cm_per_s > 0)
    canvas.text({middle.x, a.high.y + 18}, "v_{imp}\u00a0/\u00a0v_{esc}", across);
}

std::string axes(const PhaseDiagram& diagram, const Frame& frame, double height) {
  const Area& a = frame.area;
  const double v0 = frame.v.edges.front(), v1 = frame.v.edges.back();
  const double points_per_cm_per_s = a.width() / (v1 - v0);
  std::string text = fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\n"
      "set tmargin at screen {}\n",
      a.low.x / page_width, a.high.x / page_width, a.low.y / height, a.high.y / height);
  text += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", v0, v1, frame.theta.edges.front(),
                      frame.theta.edges.back());
  text += fmt::format("set xtics {} nomirror out scale 0.5 offset 0,0.4 font ',{}'\n",
                      tick_list(frame.v.at, points_per_cm_per_s), tick_size);
  std::string theta_ticks;
  for (const double theta : frame.theta.at)
    theta_ticks += fmt::format("{}\"{:g}\" {}", theta_ticks.empty() ? "" : ", ", theta, theta);
  text += fmt::format("set ytics ({}) nomirror out scale 0.5 offset 0.5,0 font ',{}'\n",
                      theta_ticks, tick_size);
  if (diagram.v_esc_cm_per_s > 0) {
    const double unit = diagram.v_esc_cm_per_s;
    text += fmt::format(
        "set x2range [{}:{}]\nset x2tics {} nomirror out scale 0.5 offset 0,-0.4 "
        "font ',{}'\n",
        v0, v1, tick_list(round_ticks(v0 / unit, v1 / unit, 8), points_per_cm_per_s, unit),
        tick_size);
  }
  return text;
}

std::string colour_bar(const Frame& frame, double height) {
  std::string palette;
  for (int k = 0; k <= 60; ++k) {
    const double value = k / 60.0;
    // The palette jumps where remnants stop being extremely elongated.
    if (k == 18) palette += fmt::format(", {} '{}'", value, hex(b_over_a_colour(value - 1e-9)));
    palette += fmt::format("{}{} '{}'", k ? ", " : "", value, hex(b_over_a_colour(value)));
  }
  return fmt::format(
      "set palette maxcolors 0 defined ({})\nset cbrange [0:1]\n"
      "set cbtics (\"0\" 0, \"0.3\" 0.3, \"0.5\" 0.5, \"1\" 1) scale 0.4 offset -0.7,0 font ',{}'\n"
      "set colorbox vertical user origin screen {},{} size screen {},{}\n",
      palette, tick_size, (frame.area.high.x + 8) / page_width, frame.area.low.y / height,
      7 / page_width, frame.area.height() / height);
}

/// The curve v sin(theta) = threshold through the map, as a gnuplot data block.
std::string threshold_curve(const PhaseDiagram& diagram, const Frame& frame) {
  std::string block = "$curve << EOD\n";
  const double v0 = frame.v.edges.front(), v1 = frame.v.edges.back();
  for (int k = 0; diagram.threshold_cm_per_s && k <= 200; ++k) {
    const double v = v0 + (v1 - v0) * k / 200, sine = *diagram.threshold_cm_per_s / v;
    if (v > 0 && sine <= 1) block += fmt::format("{} {}\n", v, degrees(std::asin(sine)));
  }
  return block + "EOD\n";
}

}  // namespace

FigureScript phase_script(const PhaseDiagram& diagram) {
  const PhaseLegend legend(diagram, page_width - 16);
  const double bottom = legend.height_pt() + below + 6, height = bottom + map_height + above;
  const Frame frame = frame_of(diagram, bottom);
  Canvas canvas(page_width, height);
  draw_cells(canvas, diagram, frame);
  legend.draw(canvas, {8, bottom - below});
  draw_titles(canvas, diagram, frame, height);
  std::string text = "set encoding utf8\nunset key\nset border lw 0.5\n";
  text += axes(diagram, frame, height) + colour_bar(frame, height) + canvas.commands();
  text += threshold_curve(diagram, frame) + "$none << EOD\n-1e9 -1e9 0\nEOD\n";
  text += "plot $none using 1:2:3 with points pt 7 lc palette";
  if (diagram.threshold_cm_per_s)
    text += fmt::format(
        ", $curve with lines lw 2.4 lc rgb '#ffffff', "
        "$curve with lines lw 1.2 lc rgb '{}'",
        hex(map_mark::ink));
  return {page_width, height, text + "\n"};
}

}  // namespace eerie
