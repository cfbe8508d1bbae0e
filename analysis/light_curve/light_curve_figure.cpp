#include "analysis/light_curve/light_curve_figure.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/drawing/gnuplot.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/file.hpp"

namespace eerie::light_curve {

namespace {

using drawing::Literal, drawing::Script, drawing::script;

constexpr double width_pt = 510, height_pt = 170;
constexpr double left_pt = 42, gap_pt = 50, right_pt = 8, top_pt = 10, bottom_pt = 28;
// Okabe & Ito's blue and vermilion; lines differ in their dashes too.
constexpr Literal particles_line = "lw 1.5 dt solid lc rgb '#0072b2'";
constexpr Literal ellipsoid_line = "lw 1.2 dt (5,3) lc rgb '#d55e00'";

/// Left and right borders of a panel as parts of the page.
Script margins(int panel) {
  const double each = (width_pt - left_pt - gap_pt - right_pt) / 2;
  const double left = left_pt + panel * (each + gap_pt);
  return script("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n", left / width_pt,
                (left + each) / width_pt);
}

Script curve_block(const LightCurve& curve) {
  const double brightest = std::ranges::max(curve.particles);
  const double brightest_ellipsoid = std::ranges::max(curve.ellipsoid);
  Script text("$curve << EOD\n");
  const std::size_t n = curve.phase.size();
  for (std::size_t k = 0; k <= n; ++k)
    text += script("{:.6g} {:.6g} {:.6g}\n", static_cast<double>(k) / static_cast<double>(n),
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

}  // namespace

drawing::Script light_curve_script(const LightCurveFigure& figure) {
  const LightCurve& curve = figure.curve;
  double highest = oumuamua_amplitude_mag;
  for (const AspectAmplitude& a : figure.amplitudes)
    highest = std::max({highest, a.particles, a.ellipsoid});
  const double depth =
      std::max({0.2, top_of(amplitude(curve.particles)), top_of(amplitude(curve.ellipsoid))});
  return curve_block(curve) + aspect_block(figure.amplitudes) +
         script(
             "set encoding utf8\nset multiplot\nunset key\nset border 3 lw 0.5\n"
             "set tics out nomirror scale 0.5,0.25\n"
             "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
             1 - top_pt / height_pt, bottom_pt / height_pt) +
         margins(0) + script("set xrange [0:1]\nset yrange [{:.2f}:-0.05]\n", depth) +
         "set xlabel 'rotation phase' offset 0,0.5\n"
         "set ylabel 'fainter than the brightest (mag)' offset 1\n" +
         script("set label 1 'aspect {:g}°' at graph 0.02,1.01 font ',6.5'\n",
                std::round(10 * degrees(curve.aspect)) / 10) +
         script("plot $curve using 1:2 with lines {}, $curve using 1:3 with lines {}\n",
                particles_line, ellipsoid_line) +
         "unset label 1\nset key at graph 0.02,0.75 left top Left reverse samplen 3 font ',6.5'\n" +
         margins(1) +
         script("set xrange [0:90]\nset xtics 15\nset yrange [0:{:.2f}]\n", top_of(highest)) +
         "set xlabel 'aspect angle: line of sight from the spin axis (deg)'\n"
         "set ylabel 'amplitude (mag)'\n" +
         script(
             "set label 2 '1I/ʻOumuamua' at 1,{0} offset 0,0.5 font ',6.5' tc rgb '#444444'\n"
             "set arrow 1 from 0,{0} to 90,{0} nohead lw 0.8 dt (1.5,2) lc rgb '#444444'\n",
             oumuamua_amplitude_mag) +
         script(
             "plot $aspect using 1:2 with lines {} title 'shadow of the particles', "
             "$aspect using 1:3 with lines {} title 'ellipsoid of inertia'\n",
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
