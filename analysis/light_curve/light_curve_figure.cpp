#include "analysis/light_curve/light_curve_figure.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/key.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/file.hpp"

namespace eerie::light_curve {

namespace {

using drawing::Literal, drawing::Script, drawing::script;

constexpr double width_pt = 510, height_pt = 190;
constexpr double left_pt = 42, gap_pt = 50, right_pt = 10, top_pt = 34, bottom_pt = 28,
                 margin_pt = 6;
// Okabe & Ito's blue and vermilion; lines differ in their dashes too.
constexpr Literal particles_line = "lw 1.5 dt solid lc rgb '#0072b2'";
constexpr Literal ellipsoid_line = "lw 1.2 dt (5,3) lc rgb '#d55e00'";
constexpr Literal oumuamua_line = "lw 0.8 dt (1.5,2) lc rgb '#444444'";

/// Left and right borders of a panel as parts of the page.
Script margins(int panel) {
  const double each = (width_pt - left_pt - gap_pt - right_pt) / 2;
  const double left = left_pt + panel * (each + gap_pt);
  return script("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n", left / width_pt,
                (left + each) / width_pt);
}

/// One rotation in hours, or 1 where the period is not known.
double rotation(const LightCurveFigure& figure) { return figure.period_s / 3600; }

Script curve_block(const LightCurve& curve, double whole) {
  const double brightest = std::ranges::max(curve.particles);
  const double brightest_ellipsoid = std::ranges::max(curve.ellipsoid);
  Script text("$curve << EOD\n");
  const std::size_t n = curve.phase.size();
  for (std::size_t k = 0; k <= n; ++k)
    text +=
        script("{:.6g} {:.6g} {:.6g}\n", whole * static_cast<double>(k) / static_cast<double>(n),
               magnitude_of(curve.particles[k % n], brightest),
               magnitude_of(curve.ellipsoid[k % n], brightest_ellipsoid));
  return text + "EOD\n";
}

Script aspect_block(const std::vector<AspectAmplitude>& amplitudes) {
  Script text("$aspect << EOD\n");
  for (const AspectAmplitude& a : amplitudes)
    text += script("{:.6g} {:.6g} {:.6g}\n", degrees(a.aspect), a.particles, a.ellipsoid);
  return text + "EOD\n";
}

/// A round number of magnitudes with room above the larger of both curves.
double top_of(double magnitudes) { return std::ceil(magnitudes * 1.08 / 0.2) * 0.2; }

/// Title and legend, once for both panels.
Script head(const LightCurveFigure& figure) {
  drawing::Canvas canvas(width_pt, height_pt);
  const drawing::Quoted& title = figure.title;
  canvas.text({margin_pt, height_pt - 8}, title,
              {.size = drawing::size_that_fits(title, width_pt - 2 * margin_pt, 7.5),
               .colour = {},
               .align = drawing::Align::left});
  drawing::Key({{drawing::in_quotes("shadow of the particles"), Script(particles_line)},
                {drawing::in_quotes("ellipsoid of inertia"), Script(ellipsoid_line)},
                {drawing::in_quotes("1I/ʻOumuamua"), Script(oumuamua_line)}},
               width_pt - 2 * margin_pt)
      .draw(canvas, {margin_pt, height_pt - 15});
  return canvas.commands();
}

}  // namespace

drawing::Script light_curve_script(const LightCurveFigure& figure) {
  const LightCurve& curve = figure.curve;
  double highest = oumuamua_amplitude_mag;
  for (const AspectAmplitude& a : figure.amplitudes)
    highest = std::max({highest, a.particles, a.ellipsoid});
  const double depth =
      std::max({0.2, top_of(amplitude(curve.particles)), top_of(amplitude(curve.ellipsoid))});
  const double whole = figure.period_s > 0 ? rotation(figure) : 1;
  const double aspect = std::round(10 * degrees(curve.aspect)) / 10;
  return curve_block(curve, whole) + aspect_block(figure.amplitudes) +
         script(
             "set encoding utf8\nset multiplot\nunset key\nset border 3 lw 0.5\n"
             "set tics out nomirror scale 0.5,0.25\n"
             "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
             1 - top_pt / height_pt, bottom_pt / height_pt) +
         head(figure) + margins(0) +
         script("set xrange [0:{:.6g}]\nset yrange [{:.2f}:-0.05]\nset format y '%.1f'\n", whole,
                depth) +
         script("set xlabel '{}, seen at an aspect of {:g}°' offset 0,0.5\n",
                figure.period_s > 0 ? Literal("time (h), one rotation")
                                    : Literal("part of one rotation"),
                aspect) +
         "set ylabel 'fainter than the brightest (mag)' offset 1\n" +
         script("plot $curve using 1:2 with lines {}, $curve using 1:3 with lines {}\n",
                particles_line, ellipsoid_line) +
         "unset label\nunset arrow\n" + margins(1) +
         script("set xrange [0:90]\nset xtics 15\nset yrange [0:{:.2f}]\n", top_of(highest)) +
         "set xlabel 'aspect angle: line of sight from the spin axis (deg)'\n"
         "set ylabel 'amplitude (mag)'\n" +
         script("set arrow from 0,{0} to 90,{0} nohead {1}\n", oumuamua_amplitude_mag,
                oumuamua_line) +
         script("plot $aspect using 1:2 with lines {}, $aspect using 1:3 with lines {}\n",
                particles_line, ellipsoid_line) +
         "unset multiplot\n";
}

void draw_light_curve(const std::filesystem::path& path, const LightCurveFigure& figure) {
  drawing::run_gnuplot(
      drawing::gnuplot_terminal(path, width_pt, height_pt) + light_curve_script(figure), path);
}

std::vector<std::filesystem::path> write_light_curve(const std::filesystem::path& picture,
                                                     const LightCurveFigure& figure) {
  const std::string stem = (picture.parent_path() / picture.stem()).string();
  const std::vector<std::filesystem::path> files = {picture, stem + ".csv", stem + "-aspect.csv"};
  draw_light_curve(files[0], figure);
  install_text(files[1], light_curve_csv(figure.curve));
  install_text(files[2], amplitudes_csv(figure.amplitudes));
  return files;
}

}  // namespace eerie::light_curve
