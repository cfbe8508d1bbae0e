#include "analysis/figures/odds_figure.hpp"

#include <algorithm>

#include "analysis/drawing/gnuplot.hpp"
#include "solver/base/error.hpp"

namespace eerie::figures {

namespace {

using drawing::Literal, drawing::Script, drawing::script;

constexpr double width_pt = 252, height_pt = 190;  // a column is 88 mm wide
constexpr double left_pt = 42, right_pt = 12, top_pt = 20, bottom_pt = 30;
constexpr double legend_line_pt = 9.5;
constexpr Literal colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};

}  // namespace

drawing::Script odds_script(const std::vector<OddsCurve>& curves) {
  if (curves.empty()) throw InputError("there is no result, so no odds can be drawn");
  Script data, plots;
  double highest = 0;
  std::size_t k = 0;
  for (const OddsCurve& curve : curves) {
    const Script block = script("$c{}", k);
    const Literal colour = colours[k++ % std::size(colours)];
    data += script("{} << EOD\n", block);
    for (const OddsCurve::Point& p : curve.points) {
      data += script("{:.8g} {:.8g} {:.8g} {:.8g}\n", p.dispersion_cm_per_s, 100 * p.p,
                     100 * std::max(0.0, p.p - p.error), 100 * (p.p + p.error));
      highest = std::max(highest, 100 * (p.p + p.error));
    }
    data += script("EOD\n");
    plots += script(
        "{0} using 1:3:4 with filledcurves fc rgb '{1}' fs transparent solid 0.25 notitle, "
        "{0} using 1:2 with lines lw 1.1 lc rgb '{1}' title {2}, ",
        block, colour, drawing::in_quotes(curve.name));
  }
  const double panel = height_pt - top_pt - bottom_pt;
  const double legend = std::min(0.5, legend_line_pt * static_cast<double>(k) / panel + 0.05);
  return data +
         script(
             "set encoding utf8\nset border 3 lw 0.5\nset tics out nomirror scale 0.5,0.25 font "
             "',7'\n"
             "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
             "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
             "set title 'collisions that leave a largest remnant with b/a < 0.3' font ',7.5' "
             "offset 0,-0.6\n"
             "set logscale x\nset xtics (1, 2, 5, 10, 20, 50, 100)\n"
             "set yrange [0:{:.6g}]\nset format y '%g %%'\n"
             "set xlabel 'dispersion of relative velocities far away, cm/s' offset 0,0.5 font "
             "',7.5'\n"
             "set ylabel 'of all collisions' offset 1 font ',7.5'\n"
             "set key inside right top Right samplen 3 spacing 1.05 font ',6.5'\n",
             left_pt / width_pt, 1 - right_pt / width_pt, 1 - top_pt / height_pt,
             bottom_pt / height_pt, std::max(highest, 1e-3) * 1.05 / (1 - legend)) +
         script("plot {}1/0 notitle\n", plots);
}

void draw_odds(const std::filesystem::path& path, const std::vector<OddsCurve>& curves) {
  drawing::run_gnuplot(drawing::gnuplot_terminal(path, width_pt, height_pt) + odds_script(curves),
                       path);
}

}  // namespace eerie::figures
