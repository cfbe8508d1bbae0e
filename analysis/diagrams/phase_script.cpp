#include "analysis/diagrams/phase_script.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/diagrams/phase_layout.hpp"
#include "analysis/diagrams/phase_legend.hpp"
#include "solver/base/constants.hpp"

namespace eerie::diagrams {

namespace {

using drawing::Script, drawing::script;

/// Before the next word of a list.
drawing::Literal separator(const Script& list) {
  return list.empty() ? drawing::Literal("") : drawing::Literal(", ");
}

/// gnuplot's list of ticks at the given data values: ("15" 15, ...); words that would touch are
/// left out. `upwards`: along the vertical axis.
Script tick_list(const std::vector<double>& values, double points_per_unit, double unit = 1,
                 bool upwards = false) {
  Script list;
  double free_from = -1e300;
  for (const double value : values) {
    const drawing::Quoted words = drawing::marked_up("{:g}", value);
    const double at = value * unit * points_per_unit;
    const double half = upwards ? tick_size / 2 : drawing::text_width(words, tick_size) / 2;
    const bool fits = at - half >= free_from;
    if (fits) free_from = at + half + 2.5;
    list += script("{}{} {}", separator(list), fits ? words : drawing::Quoted(), value * unit);
  }
  return "(" + list + ")";
}

/// Where axes have ticks: at the cells, or at round numbers where diagrams have cells at different
/// places.
struct TickValues {
  std::vector<double> v, theta;
};
TickValues tick_values(const std::vector<PhaseDiagram>& diagrams, const PanelFrame& frame) {
  std::vector<double> v, theta;
  std::size_t most_v = 0, most_theta = 0;
  for (const PhaseDiagram& diagram : diagrams) {
    const CellGrid grid(diagram);
    v.insert(v.end(), grid.v.at.begin(), grid.v.at.end());
    theta.insert(theta.end(), grid.theta.at.begin(), grid.theta.at.end());
    most_v = std::max(most_v, grid.v.at.size());
    most_theta = std::max(most_theta, grid.theta.at.size());
  }
  TickValues ticks{statistics::map_axis(v).at, statistics::map_axis(theta).at};
  if (ticks.v.size() > most_v)
    ticks.v = statistics::round_ticks(frame.v_low, frame.v_high,
                                      static_cast<int>(frame.area.width() / 18));
  if (ticks.theta.size() > most_theta)
    ticks.theta = statistics::round_ticks(frame.theta_low, frame.theta_high, 8);
  return ticks;
}

Script axes(const PhasePanel& panel, const TickValues& values, const PhaseLayout& page) {
  const PanelFrame& f = panel.frame;
  const drawing::Area& a = f.area;
  const double across = a.width() / (f.v_high - f.v_low);
  const double upwards = a.height() / (f.theta_high - f.theta_low);
  Script text = script(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\n"
      "set tmargin at screen {}\n",
      a.low.x / page.width, a.high.x / page.width, a.low.y / page.height, a.high.y / page.height);
  text += script("set xrange [{}:{}]\nset yrange [{}:{}]\n", f.v_low, f.v_high, f.theta_low,
                 f.theta_high);
  text += script("set xtics {} nomirror out scale 0.5 offset 0,0.4 font ',{}'\n",
                 tick_list(values.v, across), tick_size);
  text += script("set ytics {} nomirror out scale 0.5 offset 0.5,0 font ',{}'\n",
                 tick_list(values.theta, upwards, 1, true), tick_size);
  if (!panel.labels_below) text += "unset xtics\n";
  if (!panel.labels_left) text += "unset ytics\n";
  text += "unset x2tics\n";
  if (panel.labels_above) {
    const double unit = panel.diagram->v_esc_cm_per_s;
    const int most = static_cast<int>(a.width() / 22);
    text += script(
        "set x2range [{}:{}]\nset x2tics {} nomirror out scale 0.5 offset 0,-0.4 font ',{}'\n",
        f.v_low, f.v_high,
        tick_list(statistics::round_ticks(f.v_low / unit, f.v_high / unit, most), across, unit),
        tick_size);
  }
  return text;
}

void draw_titles(drawing::Canvas& canvas, const PhasePanel& panel) {
  const drawing::Area& a = panel.frame.area;
  const drawing::Point middle = a.centre();
  const drawing::Style across{.size = 7, .colour = map_mark::ink};
  drawing::Style upwards = across;
  upwards.upwards = true;
  if (panel.labels_below)
    canvas.text({middle.x, a.low.y - 17}, drawing::marked_up("v_{{imp}}\u00a0(cm/s)"), across);
  if (panel.labels_left)
    canvas.text({a.low.x - 28, middle.y}, drawing::marked_up("θ_{{imp}}\u00a0(deg)"), upwards);
  if (panel.labels_above)
    canvas.text({middle.x, a.high.y + 18}, drawing::marked_up("v_{{imp}}\u00a0/\u00a0v_{{esc}}"),
                across);
  if (!panel.title.empty())
    canvas.text({middle.x, a.high.y + (panel.labels_above ? 29 : 6)}, panel.title, across);
}

/// gnuplot's palette and ticks go by the part of the scale, so that any scale can be drawn.
Script colour_bar(drawing::Canvas& canvas, const MapScale& scale, const drawing::Area& bar,
                  const PhaseLayout& page) {
  constexpr int steps = 100;
  Script palette, ticks;
  for (int k = 0; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    // The palette of b/a jumps where remnants stop being extremely elongated.
    if (k == 30) palette += script(", {} '{}'", part, scale.at_part(part - 1e-9));
    palette += script("{}{} '{}'", separator(palette), part, scale.at_part(part));
  }
  for (const double tick : scale.ticks)
    ticks += script("{}\"{:g}\" {}", separator(ticks), tick, scale.part(tick));
  canvas.text({bar.high.x + bar_title_distance(scale), bar.centre().y},
              drawing::marked_up("{}", name_of(scale.quantity).title),
              {.size = 7, .colour = map_mark::ink, .upwards = true});
  return script(
      "set palette maxcolors 0 defined ({})\nset cbrange [0:1]\n"
      "set cbtics ({}) scale 0.4 offset -0.7,0 font ',{}'\n"
      "set colorbox vertical user origin screen {},{} size screen {},{}\n",
      palette, ticks, tick_size, bar.low.x / page.width, bar.low.y / page.height,
      bar.width() / page.width, bar.height() / page.height);
}

/// The curve v sin(theta) = threshold through a panel, as a gnuplot data block.
Script threshold_curve(const PhasePanel& panel) {
  Script block("$curve << EOD\n");
  const double v0 = panel.frame.v_low, v1 = panel.frame.v_high;
  for (int k = 0; panel.diagram->threshold_cm_per_s && k <= 200; ++k) {
    const double v = v0 + (v1 - v0) * k / 200, sine = *panel.diagram->threshold_cm_per_s / v;
    if (v > 0 && sine <= 1) block += script("{} {}\n", v, degrees(std::asin(sine)));
  }
  return block + "EOD\n";
}

bool has_borders(const PhasePanel& panel) {
  return panel.diagram->borders && panel.scale.quantity == MapQuantity::p_largest_eer;
}

Script block_of(const drawing::Literal& name, const std::vector<statistics::Isoline>& lines) {
  Script block = script("{} << EOD\n", name);
  for (const statistics::Isoline& line : lines) {
    for (const auto& [v, theta] : line) block += script("{} {}\n", v, theta);
    block += "\n";
  }
  return block + "EOD\n";
}

Script border_curves(const PhasePanel& panel) {
  if (!has_borders(panel)) return {};
  return block_of("$half", panel.diagram->borders->half) +
         block_of("$ends", panel.diagram->borders->ends);
}

Script plot(const PhasePanel& panel) {
  Script text("plot $none using 1:2:3 with points pt 7 lc palette");
  const auto add = [&](const drawing::Literal& block, double casing, double width,
                       const drawing::Colour& colour) {
    text += script(", {} with lines lw {} lc rgb '#ffffff', {} with lines lw {} lc rgb '{}'", block,
                   casing, block, width, colour);
  };
  if (panel.diagram->threshold_cm_per_s) add("$curve", 2.4, 1.2, map_mark::ink);
  if (has_borders(panel)) {
    add("$ends", 1.4, 0.6, map_mark::border);
    add("$half", 2.2, 1.4, map_mark::border);
  }
  return text + "\n";
}

CellWords words_of(const PhasePanel& panel) {
  CellWords words =
      cell_words(CellGrid(*panel.diagram), panel.frame, panel.scale.quantity, panel.letters);
  words.curve = panel.diagram->threshold_cm_per_s;
  words.fractions_only = has_borders(panel);
  return words;
}

bool has_result(const PhaseDiagram& diagram) {
  return std::ranges::any_of(diagram.cells, &PhaseCell::has_result);
}

/// A figure without the diagrams that would be empty panels, unless all are, and their names.
struct DrawnFigure {
  PhaseFigure figure;
  std::vector<drawing::Quoted> left_out;

  explicit DrawnFigure(const PhaseFigure& whole) : figure(whole) {
    if (std::ranges::none_of(whole.diagrams, has_result)) return;
    std::erase_if(figure.diagrams, [](const PhaseDiagram& d) { return !has_result(d); });
    for (const PhaseDiagram& d : whole.diagrams)
      if (!has_result(d)) left_out.push_back(name_of_place(d));
  }
};

/// Whether some cell has room for the letter of its class.
bool letters_fit(const PhaseLayout& page) {
  return std::ranges::any_of(page.panels, [](const PhasePanel& panel) {
    if (!panel.letters) return false;
    const CellGrid grid(*panel.diagram);
    const CellWords words = words_of(panel);
    for (std::size_t k = 0; k < grid.cells.size(); ++k) {
      if (grid.cells[k] == nullptr || !grid.cells[k]->has_result()) continue;
      const auto area = grid.area(panel.frame, k % grid.v.at.size(), k / grid.v.at.size());
      const CellLine line{letter_words(*grid.cells[k]), words.letter_size, true};
      if (line.width() <= area.width() && line.height() <= area.height()) return true;
    }
    return false;
  });
}

/// The legend stands where the last row has no panel, if there is room, else below the panels.
struct LegendPlace {
  PhaseLayout page;
  PhaseLegend legend;

  explicit LegendPlace(const DrawnFigure& drawn)
      : page(phase_layout(drawn.figure, 0)), legend(make(drawn, page.width - 2 * legend_margin)) {
    if (page.gap) {
      const PhaseLegend beside = make(drawn, page.gap->width());
      if (beside.height_pt() <= page.gap->height()) {
        legend = beside;
        page.legend = {page.gap->low.x, page.gap->high.y};
        return;
      }
    }
    page = phase_layout(drawn.figure, legend.height_pt());
  }

 private:
  PhaseLegend make(const DrawnFigure& drawn, double width_pt) const {
    return {drawn.figure, width_pt, letters_fit(page), drawn.left_out};
  }
};

}  // namespace

FigureScript phase_script(const PhaseFigure& whole) {
  const DrawnFigure drawn(whole);
  const PhaseFigure& figure = drawn.figure;
  const LegendPlace legend(drawn);
  const PhaseLayout& page = legend.page;
  Script text("set encoding utf8\nunset key\nset border lw 0.5\n$none << EOD\n-1e9 -1e9 0\nEOD\n");
  text += "set multiplot\n";
  for (std::size_t k = 0; k < page.panels.size(); ++k) {
    const PhasePanel& panel = page.panels[k];
    const drawing::Area& a = panel.frame.area;
    drawing::Canvas canvas(page.width, page.height);
    const CellGrid grid(*panel.diagram);
    draw_cells(canvas, grid, panel.frame, panel.scale, words_of(panel));
    draw_titles(canvas, panel);
    Script bar("unset colorbox\n");
    if (panel.bar)
      bar = colour_bar(canvas, panel.scale,
                       {{a.high.x + bar_gap, a.low.y}, {a.high.x + bar_gap + bar_width, a.high.y}},
                       page);
    if (k == 0) {
      if (page.shared_bar) bar = colour_bar(canvas, panel.scale, page.bar, page);
      legend.legend.draw(canvas, page.legend);
      canvas.text({page.width / 2, page.height - 7}, page.title,
                  {.size = drawing::size_that_fits(page.title, page.width - 8, 7),
                   .colour = map_mark::ink});
    }
    const TickValues ticks = page.own_axes ? tick_values({*panel.diagram}, panel.frame)
                                           : tick_values(figure.diagrams, panel.frame);
    text += axes(panel, ticks, page) + bar + canvas.commands() + threshold_curve(panel) +
            border_curves(panel) + plot(panel) + "unset object\nunset label\nunset arrow\n";
  }
  return {page.width, page.height, text + "unset multiplot\n"};
}

}  // namespace eerie::diagrams
