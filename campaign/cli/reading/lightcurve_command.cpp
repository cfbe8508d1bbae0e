#include <cmath>
#include <optional>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/grouped.hpp"
#include "analysis/drawing/impact_words.hpp"
#include "analysis/light_curve/light_curve_figure.hpp"
#include "analysis/light_curve/turning_remnant.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "solver/base/constants.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;

namespace {

/// A rotation further from the shortest axis is told.
constexpr double most_tilt_deg = 10;

struct LightCurveArguments {
  fs::path database;
  std::string job;
  int rank = 1;
  double aspect_deg = 90;
  fs::path picture;  ///< empty: none
};

/// Every 15 degrees for people: the files have them all.
Table table_of_amplitudes(const std::vector<light_curve::AspectAmplitude>& amplitudes, bool all) {
  using light_curve::AspectAmplitude;
  const auto degrees_of = [](const AspectAmplitude& p) {
    return std::round(1e6 * degrees(p.aspect)) / 1e6;
  };
  std::vector<AspectAmplitude> some = amplitudes;
  if (!all)
    std::erase_if(some,
                  [&](const AspectAmplitude& p) { return std::fmod(degrees_of(p), 15) != 0; });
  return table_of<AspectAmplitude>({{both("aspect_deg", "aspect deg", "{:g}"), degrees_of},
                                    {both("particles_mag", "particles mag", "{:.3f}"),
                                     [](const AspectAmplitude& p) { return p.particles; }},
                                    {both("ellipsoid_mag", "ellipsoid mag", "{:.3f}"),
                                     [](const AspectAmplitude& p) { return p.ellipsoid; }}},
                                   some);
}

void say_shape(Answer& answer, const light_curve::TurningRemnant& seen, int rank) {
  const shapes::Shape& s = seen.body.shape;
  answer.say("remnant {}: {} particles, {:.0f} x {:.0f} x {:.0f} m, b/a {:.3f}, c/a {:.3f}", rank,
             seen.body.x.size(), s.a, s.b, s.c, s.b_over_a(), s.c_over_a());
  if (seen.period && seen.tilt)
    answer.say("; turns in {:.2f} h, {:.1f} deg from its shortest axis", *seen.period / 3600,
               degrees(*seen.tilt));
  answer.say("\n");
}

Answer show_light_curve(const LightCurveArguments& a) {
  if (!a.picture.empty()) drawing::require_figure_file(a.picture);
  const fs::path path = queries::snapshot_of(a.database, a.job);
  const io::Snapshot snapshot = io::read_snapshot(path);
  const light_curve::TurningRemnant seen = light_curve::remnant_of(snapshot, a.rank, path);
  const light_curve::LightCurveFigure figure{
      light_curve::light_curve(seen.body, radians(a.aspect_deg)),
      light_curve::amplitudes_over_aspect(seen.body),
      drawing::marked_up("{}; remnant {} at {} s", drawing::impact_words(snapshot.scene), a.rank,
                         drawing::in_quotes(drawing::grouped(std::llround(snapshot.state.time)))),
      seen.period.value_or(0)};
  const double by_particles = light_curve::amplitude(figure.curve.particles);
  const double by_ellipsoid =
      light_curve::ellipsoid_amplitude(seen.body.shape, figure.curve.aspect);
  std::vector<fs::path> files;
  if (!a.picture.empty()) {
    text::require_folder_of(a.picture);
    files = light_curve::write_light_curve(a.picture, figure);
  }
  Answer answer;
  answer.data = {{"snapshot", path.string()},
                 {"time_s", snapshot.state.time},
                 {"remnant", light_curve::to_json(seen, a.rank)},
                 {"aspect_deg", a.aspect_deg},
                 {"particles_mag", by_particles},
                 {"ellipsoid_mag", by_ellipsoid},
                 {"oumuamua_mag", light_curve::oumuamua_amplitude_mag},
                 {"amplitude_over_aspect", records(table_of_amplitudes(figure.amplitudes, true))},
                 {"files", names_of(files)}};
  answer.say("{} at {:.6g} s\n", path, snapshot.state.time);
  say_shape(answer, seen, a.rank);
  answer.say(
      "amplitude at aspect {:g} deg: {:.2f} mag by the shadow of its particles, {:.2f} mag by its "
      "ellipsoid of inertia (1I/'Oumuamua: {:g})\n\n",
      a.aspect_deg, by_particles, by_ellipsoid, light_curve::oumuamua_amplitude_mag);
  answer.add(table_of_amplitudes(figure.amplitudes, false));
  answer.say(
      "Brightness is the area of the shadow: phase angle 0, a uniform surface, no darker "
      "limbs.\n");
  answer.add_files(files);
  if (seen.tilt && *seen.tilt > radians(most_tilt_deg))
    print_warnings(
        {fmt::format("it turns {:.0f} deg from its shortest axis: the light curve is that "
                     "of its shape once it turns about that axis, not of this tumbling",
                     degrees(*seen.tilt))});
  return answer;
}

}  // namespace

Action add_lightcurve(CLI::App& app) {
  auto a = std::make_shared<LightCurveArguments>();
  add_remnant_of_snapshot(app, a->job, a->database, a->rank);
  app.add_option("--aspect", a->aspect_deg,
                 "angle of the line of sight to the spin axis, deg; 90: equator-on")
      ->check(CLI::Range(0.0, 90.0))
      ->capture_default_str();
  app.add_option("-o,--output", a->picture,
                 "draw into this file (.svg, .png, .pdf), with tables (.csv) beside it");
  add_formats(app);
  return [a](Output&) { return show_light_curve(*a); };
}

}  // namespace eerie::cli
