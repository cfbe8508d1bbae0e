#include "analysis/disk/disk_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/key.hpp"

namespace eerie::disk {

namespace {

using drawing::Literal, drawing::Quoted, drawing::Script, drawing::script, drawing::in_quotes;

constexpr double width_pt = 255, panel_pt = 135, margin_pt = 6, title_pt = 13;
constexpr double left_pt = 36, right_pt = 14, regimes_pt = 14, bottom_pt = 28;
// Okabe & Ito's blue and vermilion, and pale fills that differ in lightness too.
constexpr Literal slow_colour = "#0072b2", fast_colour = "#d55e00";
constexpr Literal solid = "lw 1.5 dt solid", dashed = "lw 0.9 dt (6,3)";
constexpr Literal dotted = "lw 1.3 dt (1.5,2) lc rgb 'black'";
constexpr Literal thin = "lw 0.5 lc rgb '#888888'";
constexpr drawing::Colour below_fill{0xe4, 0xef, 0xf7}, between_fill{0xff, 0xf3, 0xb8},
    above_fill{0xef, 0xef, 0xef};

struct Range {
  double low, high;
  bool contains(double y) const { return y > low && y < high; }
};

/// Whole decades about the two contours that matter, with room for the others.
Range decades(const DiskFigure& figure) {
  Range y{figure.laws[0].of(slow)[0], figure.laws[0].of(fast)[0]};
  for (const Contours& c : figure.laws) {
    y.low = std::min(y.low, std::ranges::min(c.of(slow)));
    y.high = std::max(y.high, std::ranges::max(c.of(fast)));
  }
  const auto decade = [&](double value, auto round) {
    return std::pow(10, round(std::log10(value / figure.y_unit)));
  };
  return {decade(y.low / 1.3, [](double x) { return std::floor(x); }),
          decade(y.high * 2, [](double x) { return std::ceil(x); })};
}

double au(double r) { return r / astronomical_unit; }

/// r and all contours of one law, a column each.
Script contour_block(const DiskFigure& figure, std::size_t law) {
  const Contours& c = figure.laws[law];
  Script text = script("$law{} << EOD\n", law);
  for (std::size_t i = 0; i < c.r.size(); ++i) {
    text += script("{:.10g}", au(c.r[i]));
    for (const auto& values : c.y) text += script(" {:.6g}", values[i] / figure.y_unit);
    text += "\n";
  }
  return text + "EOD\n";
}

Script published_block(const DiskFigure& figure) {
  Script text("$published << EOD\n");
  for (const auto& line : figure.published) {
    for (const auto& [r, value] : line)
      text += script("{:.6g} {:.6g}\n", au(r), value / figure.y_unit);
    text += "\n";
  }
  return text + "EOD\n";
}

int column(double speed) {
  const auto* at = std::ranges::find(contour_speeds, speed);
  return 2 + static_cast<int>(at - contour_speeds.begin());
}

/// A thin contour and the place of its label, as an index of r.
struct Labelled {
  std::size_t speed, at;
};

/// Thin contours that have room for a label: in the middle, or near the right end.
std::vector<Labelled> thin_contours(const DiskFigure& figure, const Range& range) {
  const Contours& c = figure.laws[0];
  const Range room{range.low * 1.1, range.high / 1.35};
  std::vector<Labelled> found;
  for (std::size_t s = 0; s < contour_speeds.size(); ++s) {
    if (contour_speeds[s] == slow || contour_speeds[s] == fast) continue;
    for (const double place : {0.45, 0.93}) {
      const auto i = static_cast<std::size_t>(place * static_cast<double>(c.r.size() - 1));
      if (!room.contains(c.y[s][i] / figure.y_unit)) continue;
      found.push_back({s, i});
      break;
    }
  }
  return found;
}

Script contour_labels(const DiskFigure& figure, const Range& range) {
  const Contours& c = figure.laws[0];
  Script text;
  for (const auto& [s, i] : thin_contours(figure, range))
    text += script(
        "set label '{:g}' at {:.6g},{:.6g} right offset 0,0.4 front font ',6' tc rgb '#444444'\n",
        100 * contour_speeds[s], au(c.r[i]), c.y[s][i] / figure.y_unit);
  return text;
}

/// Which law of drag holds where: names above the frame, thin lines between.
Script regimes(const Contours& c) {
  Script text;
  const double decades_wide = std::log10(c.r.back() / c.r.front());
  for (std::size_t first = 0, i = 1; i <= c.r.size(); ++i) {
    if (i < c.r.size() && c.drag[i].regime == c.drag[first].regime) continue;
    const double from = au(c.r[first]), to = au(c.r[std::min(i, c.r.size() - 1)]);
    if (std::log10(to / from) > 0.08 * decades_wide)
      text += script("set label {} at {:.6g},graph 1.03 center font ',6' tc rgb '#444444'\n",
                     in_quotes(name(c.drag[first].regime)), std::sqrt(from * to));
    if (i < c.r.size())
      text += script(
          "set arrow from {0:.10g},graph 0 to {0:.10g},graph 1 nohead front lw 0.4 dt 3 lc rgb "
          "'#444444'\n",
          to);
    first = i;
  }
  return text;
}

Script fills(const Range& range) {
  const auto clipped = [&](int c) {
    return script("(${0} < {1} ? {1} : ${0} > {2} ? {2} : ${0})", c, range.low, range.high);
  };
  const Script low = clipped(column(slow)), high = clipped(column(fast));
  const auto fill = [](const Script& from, const Script& to, drawing::Colour colour) {
    return script("$law0 using 1:{}:{} with filledcurves fc rgb '{}' fs solid notitle", from, to,
                  colour);
  };
  return fill(script("({})", range.low), low, below_fill) + ", " + fill(low, high, between_fill) +
         ", " + fill(high, script("({})", range.high), above_fill);
}

Script curves(const DiskFigure& figure, const Range& range) {
  Script text;
  for (const Labelled& one : thin_contours(figure, range))
    text +=
        script(", $law0 using 1:{} with lines {} notitle", column(contour_speeds[one.speed]), thin);
  for (std::size_t law = figure.laws.size(); law-- > 0;)
    for (const double speed : {slow, fast})
      text += script(", $law{} using 1:{} with lines {} lc rgb '{}' notitle", law, column(speed),
                     law == 0 ? solid : dashed, speed == slow ? slow_colour : fast_colour);
  if (!figure.published.empty())
    text += script(", $published using 1:2 with lines {} notitle", dotted);
  return text;
}

std::string words(DragLaw law) {
  return law == DragLaw::published ? "published drag" : "Weidenschilling's drag";
}

drawing::Key key_of(const DiskFigure& figure, const Range& range) {
  const std::string first = words(figure.laws[0].law);
  std::vector<drawing::KeyEntry> entries = {
      {in_quotes("40 cm/s, " + first), script("{} lc rgb '{}'", solid, fast_colour)},
      {in_quotes("15 cm/s, " + first), script("{} lc rgb '{}'", solid, slow_colour)}};
  if (figure.laws.size() > 1)
    entries.push_back(
        {in_quotes("dashed: " + words(figure.laws[1].law)), script("{} lc rgb '#555555'", dashed)});
  if (!figure.published.empty())
    entries.push_back({in_quotes("40 cm/s in the paper's text"), Script(dotted)});
  if (!thin_contours(figure, range).empty())
    entries.push_back({in_quotes("other speeds, cm/s"), Script(thin)});
  entries.push_back({in_quotes("elongated bodies can form"), {}, {}, between_fill});
  entries.push_back({in_quotes("slower"), {}, {}, below_fill});
  entries.push_back({in_quotes("faster"), {}, {}, above_fill});
  entries.push_back({in_quotes("above the frame: law of gas drag")});
  return {std::move(entries), width_pt - 2 * margin_pt};
}

double top_of(const DiskFigure& figure) {
  return title_pt + key_of(figure, decades(figure)).height_pt() + regimes_pt;
}

double height_of(const DiskFigure& figure) { return top_of(figure) + panel_pt + bottom_pt; }

/// Title and legend, above the panel.
Script head(const DiskFigure& figure) {
  const double height_pt = height_of(figure);
  const Quoted title = in_quotes(figure.title);
  drawing::Canvas canvas(width_pt, height_pt);
  canvas.text({margin_pt, height_pt - 7}, title,
              {.size = drawing::size_that_fits(title, width_pt - 2 * margin_pt, 7),
               .colour = {},
               .align = drawing::Align::left});
  key_of(figure, decades(figure)).draw(canvas, {margin_pt, height_pt - title_pt});
  return canvas.commands();
}

/// The law asked for first; the other one too where both know the body.
std::vector<DragLaw> laws_of(DragLaw law, const Body& body) {
  if (!has_published_drag(body)) return {law};
  return {law, law == DragLaw::published ? DragLaw::weidenschilling : DragLaw::published};
}

}  // namespace

DiskFigure turbulence_figure(DragLaw law, const Body& body, double r_low, double r_high) {
  const std::vector<double> r = contour_distances(r_low, r_high);
  DiskFigure figure{fmt::format("Speed of encounters in turbulence: bodies of {:g} m, {:g} kg/m³",
                                body.radius, body.density),
                    "strength of turbulence α (no unit)",
                    1,
                    {},
                    {}};
  for (const DragLaw one : laws_of(law, body)) figure.laws.push_back(alpha_contours(one, body, r));
  if (has_published_drag(body)) {
    constexpr double limit = 5e-4, bend_au = 20, end_au = 1000;
    const double slope = (end_au / bend_au) * (end_au / bend_au);
    figure.published = {{{astronomical_unit, limit},
                         {bend_au * astronomical_unit, limit},
                         {end_au * astronomical_unit, limit * slope}}};
  }
  return figure;
}

DiskFigure stirring_figure(DragLaw law, const Body& body, const Stirrers& stirrers, double r_low,
                           double r_high) {
  const std::vector<double> r = contour_distances(r_low, r_high);
  DiskFigure figure{
      fmt::format(
          "Speed of encounters among larger bodies, {:g} % of all solids: bodies of {:g} m, {:g} "
          "kg/m³",
          100 * stirrers.solid_fraction, body.radius, body.density),
      "radius of large bodies R (km)",
      1000,
      {},
      {}};
  for (const DragLaw one : laws_of(law, body))
    figure.laws.push_back(stirrer_contours(one, body, stirrers, r));
  const Stirrers usual;
  if (has_published_drag(body) && stirrers.solid_fraction == usual.solid_fraction &&
      stirrers.density == usual.density)
    figure.published = {{{0.85 * astronomical_unit, 2000}, {1.2 * astronomical_unit, 2000}},
                        {{20 * astronomical_unit, 7000}, {1000 * astronomical_unit, 7000}}};
  return figure;
}

drawing::Script disk_script(const DiskFigure& figure) {
  const Range y = decades(figure);
  Script text;
  for (std::size_t law = 0; law < figure.laws.size(); ++law) text += contour_block(figure, law);
  text += published_block(figure);
  const Contours& first = figure.laws[0];
  const double height_pt = height_of(figure), top_pt = top_of(figure);
  text += script(
      "set encoding utf8\nunset key\nset border lw 0.5 front\nset tics out nomirror scale 0.5,0.25 "
      "front\n"
      "set logscale xy\nset xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n"
      "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\n"
      "set bmargin at screen {}\n",
      au(first.r.front()), au(first.r.back()), y.low, y.high, left_pt / width_pt,
      1 - right_pt / width_pt, 1 - top_pt / height_pt, bottom_pt / height_pt);
  text += script("set format y '{}'\n", y.low < 0.01 ? Literal("10^{%T}") : Literal("%g"));
  text += "set xlabel 'distance from the star r (AU)' offset 0,0.6\n";
  text +=
      script("set label {} at screen {},{} center rotate font ',7'\n", in_quotes(figure.y_label),
             6 / width_pt, (height_pt - top_pt + bottom_pt) / 2 / height_pt);
  return text + head(figure) + contour_labels(figure, y) + regimes(first) + "plot " + fills(y) +
         curves(figure, y) + "\n";
}

void draw_disk(const std::filesystem::path& path, const DiskFigure& figure) {
  drawing::run_gnuplot(
      drawing::gnuplot_terminal(path, width_pt, height_of(figure)) + disk_script(figure), path);
}

}  // namespace eerie::disk
