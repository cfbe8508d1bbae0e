#include "analysis/figures/size_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/remnants/remnants.hpp"
#include "solver/base/error.hpp"

namespace eerie::figures {

namespace {

using drawing::Literal, drawing::Script, drawing::script;

constexpr double width_pt = 252, height_pt = 190;  // a column is 88 mm wide
constexpr double left_pt = 40, right_pt = 8, top_pt = 8, bottom_pt = 30;
/// Okabe & Ito's colours; dashes differ too.
struct Look {
  Literal colour;
  Literal dashes;
};
constexpr Look looks[] = {{"#0072b2", "solid"},     {"#d55e00", "(6,2)"},
                          {"#009e73", "(2,2)"},     {"#cc79a7", "(8,2,2,2)"},
                          {"#56b4e9", "(4,1,1,1)"}, {"#e69f00", "(10,4)"}};

std::string grouped(std::int64_t number) {
  std::string digits = fmt::format("{}", number);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), ",");
  return digits;
}

drawing::Quoted title(const SizeDistribution& d) {
  return drawing::in_quotes(fmt::format(
      "{}: {} particles per target, {} impact{}", d.name, grouped(d.particles_per_target),
      grouped(static_cast<std::int64_t>(d.impacts)), d.impacts == 1 ? "" : "s"));
}

/// Part of the panel's height that the legend takes: a line for each distribution, one for limits.
double legend_part(std::size_t distributions) {
  const double lines = static_cast<double>(distributions) + 1;
  return std::min(0.6, (lines * 9.5 + 8) / (height_pt - top_pt - bottom_pt));
}

/// The axis of counts, its curves below the legend. Linear where there are a few remnants per
/// impact, as most impacts leave.
Script count_axis(double highest, double legend) {
  constexpr double few = 8, lowest = 0.3;
  if (highest < few) return script("set yrange [0:{:.6g}]\n", highest * 1.05 / (1 - legend));
  return script("set logscale y\nset yrange [{}:{:.6g}]\n", lowest,
                lowest * std::pow(1.15 * highest / lowest, 1 / (1 - legend)));
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
  const double legend = legend_part(distributions.size());
  double smallest = 1, highest = 0;
  std::size_t k = 0;
  for (const SizeDistribution& d : distributions) {
    const Look& look = looks[k % std::size(looks)];
    const Script block = script("$d{}", k++);
    const std::vector<SizeStep> all = steps(d);
    if (all.empty()) continue;
    text += script("{} << EOD\n{:.8g} 0\n", block, all.front().mass);
    for (const SizeStep& step : all) text += script("{:.8g} {:.8g}\n", step.mass, step.count);
    // Flat down to the limit, where knowledge ends.
    text += script("{:.8g} {:.8g}\nEOD\n", std::min(d.limit, all.back().mass), all.back().count);
    smallest = std::min({smallest, d.limit, all.back().mass});
    highest = std::max(highest, all.back().count);
    curves += script("{} using 1:2 with steps lw 1.1 dt {} lc rgb '{}' title {}, ", block,
                     look.dashes, look.colour, title(d));
    lines += script(
        "set arrow from {0:.8g}, graph 0 to {0:.8g}, graph {2:.4f} nohead back lw 0.7 dt (1,3) lc "
        "rgb "
        "'{1}'\n",
        d.limit, look.colour, 1 - legend);
  }
  if (highest == 0)
    throw InputError(
        fmt::format("no impact has left a remnant of at least {} particles; there is "
                    "nothing to draw",
                    remnants::remnant_min_particles));
  return text +
         script(
             "set encoding utf8\nset border 3 lw 0.5\nset tics out nomirror scale 0.5,0.25 font "
             "',7'\n"
             "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
             "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
             "set logscale x\nset xrange [{:.6g}:1.05]\n"
             "set xtics add (0.02, 0.05, 0.1, 0.2, 0.5, 1)\n"
             "set format '%g'\n"
             "set xlabel 'mass of the remnant m / (M_{{target}} + M_{{impactor}})' offset 0,0.5\n"
             "set ylabel 'remnants per impact, N(≥ m)' offset 1\n"
             "set key inside right top Right samplen 3 spacing 1.05 font ',6.5'\n",
             left_pt / width_pt, 1 - right_pt / width_pt, 1 - top_pt / height_pt,
             bottom_pt / height_pt, smallest / 1.3) +
         count_axis(highest, legend) + lines +
         script(
             "plot {}1/0 with lines lw 0.7 dt (1,3) lc rgb '#000000' title 'limits of "
             "resolution: {} particles'\n",
             curves, remnants::remnant_min_particles);
}

void draw_sizes(const std::filesystem::path& path,
                const std::vector<SizeDistribution>& distributions) {
  drawing::run_gnuplot(
      drawing::gnuplot_terminal(path, width_pt, height_pt) + sizes_script(distributions), path);
}

}  // namespace eerie::figures
