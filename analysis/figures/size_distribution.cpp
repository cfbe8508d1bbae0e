#include "analysis/figures/size_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/grouped.hpp"
#include "analysis/drawing/key.hpp"
#include "analysis/figures/value_axis.hpp"
#include "analysis/remnants/remnants.hpp"
#include "solver/base/error.hpp"

namespace eerie::figures {

namespace {

using drawing::grouped, drawing::Literal, drawing::Script, drawing::script;

constexpr double width_pt = 255, panel_pt = 150;  // a column is 9 cm wide
constexpr double left_pt = 40, right_pt = 10, title_pt = 14, bottom_pt = 30, margin_pt = 6;
constexpr Literal limit_dashes = "lw 0.7 dt (1,3)";
/// Okabe & Ito's colours; dashes differ too.
struct Look {
  Literal colour;
  Literal dashes;
};
constexpr Look looks[] = {{"#0072b2", "solid"},     {"#d55e00", "(6,2)"},
                          {"#009e73", "(2,2)"},     {"#cc79a7", "(8,2,2,2)"},
                          {"#56b4e9", "(4,1,1,1)"}, {"#e69f00", "(10,4)"}};

drawing::Quoted title(const SizeDistribution& d) {
  return drawing::in_quotes(fmt::format(
      "{}: {} particles per target, {} impact{}", d.name, grouped(d.particles_per_target),
      grouped(static_cast<std::int64_t>(d.impacts)), d.impacts == 1 ? "" : "s"));
}

Script curve_of(std::size_t k) {
  const Look& look = looks[k % std::size(looks)];
  return script("lw 1.1 dt {} lc rgb '{}'", look.dashes, look.colour);
}

drawing::Key key_of(const std::vector<SizeDistribution>& distributions) {
  std::vector<drawing::KeyEntry> entries;
  for (std::size_t k = 0; k < distributions.size(); ++k)
    if (!distributions[k].masses.empty()) entries.push_back({title(distributions[k]), curve_of(k)});
  entries.push_back({drawing::in_quotes(fmt::format("limit of resolution: {} particles",
                                                    remnants::remnant_min_particles)),
                     script("{} lc rgb '#000000'", limit_dashes)});
  return {std::move(entries), width_pt - 2 * margin_pt};
}

double top_of(const std::vector<SizeDistribution>& distributions) {
  return title_pt + key_of(distributions).height_pt() + 8;
}

double height_of(const std::vector<SizeDistribution>& distributions) {
  return top_of(distributions) + panel_pt + bottom_pt;
}

/// Title and legend, above the panel.
Script head(const std::vector<SizeDistribution>& distributions) {
  const double height_pt = height_of(distributions);
  std::size_t impacts = 0;
  for (const SizeDistribution& d : distributions) impacts += d.impacts;
  drawing::Canvas canvas(width_pt, height_pt);
  canvas.text({margin_pt, height_pt - 7},
              drawing::in_quotes(fmt::format("Sizes of remnants, {} impact{}",
                                             grouped(static_cast<std::int64_t>(impacts)),
                                             impacts == 1 ? "" : "s")),
              {.size = 7, .colour = {}, .align = drawing::Align::left});
  key_of(distributions).draw(canvas, {margin_pt, height_pt - title_pt});
  return canvas.commands();
}

/// The axis of counts. Linear where there are a few remnants per impact, as most impacts leave.
Script count_axis(double highest) {
  constexpr double few = 8, lowest = 0.3;
  if (highest < few) return value_axis(0, highest * 1.08);
  return script("set logscale y\nset format y '%g'\nset yrange [{}:{:.6g}]\n", lowest,
                1.3 * highest);
}

}  // namespace

double SizeDistribution::count_from(double mass) const {
  const auto end = std::ranges::upper_bound(masses, mass, std::ranges::greater());
  return static_cast<double>(end - masses.begin()) / static_cast<double>(impacts);
}

std::vector<SizeStep> steps(const SizeDistribution& d) {
  std::vector<SizeStep> all;
  for (const double mass : d.masses) {
    if (!all.empty() && all.back().mass == mass) continue;
    all.push_back({mass, d.count_from(mass)});
  }
  return all;
}

drawing::Script sizes_script(const std::vector<SizeDistribution>& distributions) {
  Script text, curves, lines;
  double smallest = 1, highest = 0;
  std::size_t k = 0;
  for (const SizeDistribution& d : distributions) {
    const Script block = script("$d{}", k), look = curve_of(k++);
    const std::vector<SizeStep> all = steps(d);
    if (all.empty()) continue;
    text += script("{} << EOD\n{:.8g} 0\n", block, all.front().mass);
    for (const SizeStep& step : all) text += script("{:.8g} {:.8g}\n", step.mass, step.count);
    // Flat down to the limit, where knowledge ends.
    text += script("{:.8g} {:.8g}\nEOD\n", std::min(d.limit, all.back().mass), all.back().count);
    smallest = std::min({smallest, d.limit, all.back().mass});
    highest = std::max(highest, all.back().count);
    curves += script("{}{} using 1:2 with steps {}", curves.empty() ? Literal("") : Literal(", "),
                     block, look);
    lines +=
        script("set arrow from {0:.8g}, graph 0 to {0:.8g}, graph 1 nohead back {1} lc rgb '{2}'\n",
               d.limit, limit_dashes, looks[(k - 1) % std::size(looks)].colour);
  }
  if (highest == 0)
    throw InputError(
        fmt::format("no impact has left a remnant of at least {} particles; there is "
                    "nothing to draw",
                    remnants::remnant_min_particles));
  const double height_pt = height_of(distributions);
  return text +
         script(
             "set encoding utf8\nset border 3 lw 0.5\nunset key\n"
             "set tics out nomirror scale 0.5,0.25 font ',7'\n"
             "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
             "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
             "set logscale x\nset xrange [{:.6g}:1.05]\n"
             "set xtics add (0.02, 0.05, 0.1, 0.2, 0.5, 1)\nset format x '%g'\n"
             "set xlabel 'mass of the remnant m / (M_{{target}} + M_{{impactor}})' offset 0,0.5\n"
             "set ylabel 'remnants per impact, N(≥ m)' offset 1\n",
             left_pt / width_pt, 1 - right_pt / width_pt, 1 - top_of(distributions) / height_pt,
             bottom_pt / height_pt, smallest / 1.3) +
         count_axis(highest) + lines + head(distributions) + "plot " + curves + "\n";
}

void draw_sizes(const std::filesystem::path& path,
                const std::vector<SizeDistribution>& distributions) {
  drawing::run_gnuplot(drawing::gnuplot_terminal(path, width_pt, height_of(distributions)) +
                           sizes_script(distributions),
                       path);
}

}  // namespace eerie::figures
