#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/light_curve/light_curve_figure.hpp"
#include "analysis/pictures/particle_view.hpp"
#include "analysis/remnants/clumps.hpp"
#include "analysis/remnants/remnants.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/options/find_job.hpp"
#include "campaign/cli/output/text_table.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/job_folder/snapshot_files.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// A rotation further from the shortest axis is told.
constexpr double most_tilt_deg = 10;

struct LightCurveArguments {
  fs::path database;
  std::string job;
  int rank = 1;
  double aspect_deg = 90;
  fs::path picture;  ///< empty: none
  bool json = false;
};

/// The snapshot itself, or the last one of a job or folder.
fs::path snapshot_of(const LightCurveArguments& a) {
  if (fs::path(a.job).extension() == ".hdf5") return a.job;
  return job_folder::snapshot_series(folder_of(a.database, a.job).path).back().path;
}

/// A remnant and how it really turns.
struct Seen {
  light_curve::SpinningBody body;
  std::optional<double> period, tilt;  ///< s; rad, of the rotation from the shortest axis
};

Seen remnant_of(const io::Snapshot& snapshot, int rank, const fs::path& path) {
  const particles::State& state = snapshot.state;
  const auto clumps =
      remnants::friends_of_friends(state.x, state.id, remnants::linking_length_over_h * state.h);
  const auto remnants = std::ranges::count_if(clumps, [](const remnants::Clump& clump) {
    return clump.size() >= remnants::remnant_min_particles;
  });
  if (rank > remnants)
    throw InputError(fmt::format("--remnant {}: {} holds {} remnant{} of at least {} particles",
                                 rank, path.string(), remnants, remnants == 1 ? "" : "s",
                                 remnants::remnant_min_particles));
  std::vector<Vec3> x, v;
  for (const std::uint32_t i : clumps[static_cast<std::size_t>(rank - 1)])
    x.push_back(state.x[i]), v.push_back(state.v[i]);
  Seen seen{light_curve::spinning_body(x, shapes::particle_radius(snapshot)), {}, {}};
  if (const auto omega = shapes::angular_velocity(x, v); omega && norm(*omega) > 0) {
    seen.period = 2 * pi / norm(*omega);
    const double along_c = std::abs(dot(*omega, seen.body.shape.axes[2])) / norm(*omega);
    seen.tilt = std::acos(std::min(along_c, 1.0));
  }
  return seen;
}

json to_json(const Seen& seen, int rank) {
  const shapes::Shape& s = seen.body.shape;
  return {{"rank", rank},
          {"particles", seen.body.x.size()},
          {"particle_radius_m", seen.body.radius},
          {"a_m", s.a},
          {"b_m", s.b},
          {"c_m", s.c},
          {"b_over_a", s.b_over_a()},
          {"c_over_a", s.c_over_a()},
          {"spin_period_h", seen.period ? json(*seen.period / 3600) : json()},
          {"spin_from_shortest_axis_deg", seen.tilt ? json(degrees(*seen.tilt)) : json()}};
}

std::vector<fs::path> write_figure(const fs::path& picture,
                                   const light_curve::LightCurveFigure& figure) {
  const fs::path stem = picture.parent_path() / picture.stem();
  const std::vector<fs::path> files = {picture, stem.string() + ".csv",
                                       stem.string() + "-aspect.csv"};
  make_folder_of(picture);
  light_curve::draw_light_curve(files[0], figure);
  install_text(files[1], light_curve::light_curve_csv(figure.curve));
  install_text(files[2], light_curve::amplitudes_csv(figure.amplitudes));
  return files;
}

std::string text_of(const json& r) {
  const json& m = r.at("remnant");
  const auto number = [](const json& value) { return value.get<double>(); };
  std::string text = fmt::format(
      "{} at {:.6g} s\nremnant {}: {} particles, {:.0f} x {:.0f} x {:.0f} m, b/a {:.3f}, c/a "
      "{:.3f}",
      r.at("snapshot").get<std::string>(), number(r.at("time_s")), m.at("rank").dump(),
      m.at("particles").dump(), number(m.at("a_m")), number(m.at("b_m")), number(m.at("c_m")),
      number(m.at("b_over_a")), number(m.at("c_over_a")));
  if (!m.at("spin_period_h").is_null())
    text += fmt::format("; turns in {:.2f} h, {:.1f} deg from its shortest axis",
                        number(m.at("spin_period_h")), number(m.at("spin_from_shortest_axis_deg")));
  text += fmt::format(
      "\namplitude at aspect {:g} deg: {:.2f} mag by the shadow of its particles, {:.2f} mag by "
      "its "
      "ellipsoid of inertia (1I/'Oumuamua: {:g})\n\n",
      number(r.at("aspect_deg")), number(r.at("particles_mag")), number(r.at("ellipsoid_mag")),
      light_curve::oumuamua_amplitude_mag);
  std::vector<std::vector<std::string>> rows = {{"aspect deg", "particles mag", "ellipsoid mag"}};
  for (const json& a : r.at("amplitude_over_aspect")) {
    if (std::fmod(number(a.at("aspect_deg")), 15) != 0) continue;  // the files have them all
    rows.push_back({fmt::format("{:g}", number(a.at("aspect_deg"))),
                    fmt::format("{:.3f}", number(a.at("particles_mag"))),
                    fmt::format("{:.3f}", number(a.at("ellipsoid_mag")))});
  }
  text += text_table(rows);
  text +=
      "Brightness is the area of the shadow: phase angle 0, a uniform surface, no darker limbs.\n";
  for (const json& file : r.at("files")) text += file.get<std::string>() + "\n";
  return text;
}

int show_light_curve(const LightCurveArguments& a) {
  if (!a.picture.empty())
    drawing::gnuplot_terminal(a.picture, 1, 1);  // refuses other formats at once
  const fs::path path = snapshot_of(a);
  const io::Snapshot snapshot = io::read_snapshot(path);
  const Seen seen = remnant_of(snapshot, a.rank, path);
  const light_curve::LightCurveFigure figure{
      light_curve::light_curve(seen.body, radians(a.aspect_deg)),
      light_curve::amplitudes_over_aspect(seen.body)};
  json report = {
      {"snapshot", path.string()},
      {"time_s", snapshot.state.time},
      {"remnant", to_json(seen, a.rank)},
      {"aspect_deg", a.aspect_deg},
      {"particles_mag", light_curve::amplitude(figure.curve.particles)},
      {"ellipsoid_mag", light_curve::ellipsoid_amplitude(seen.body.shape, figure.curve.aspect)},
      {"oumuamua_mag", light_curve::oumuamua_amplitude_mag},
      {"amplitude_over_aspect", json::array()},
      {"files", json::array()}};
  for (const light_curve::AspectAmplitude& p : figure.amplitudes)
    report["amplitude_over_aspect"].push_back(
        {{"aspect_deg", std::round(1e6 * degrees(p.aspect)) / 1e6},
         {"particles_mag", p.particles},
         {"ellipsoid_mag", p.ellipsoid}});
  if (!a.picture.empty())
    for (const fs::path& file : write_figure(a.picture, figure))
      report["files"].push_back(file.string());
  if (seen.tilt && *seen.tilt > radians(most_tilt_deg))
    print_warnings(
        {fmt::format("it turns {:.0f} deg from its shortest axis: the light curve is that "
                     "of its shape once it turns about that axis, not of this tumbling",
                     degrees(*seen.tilt))});
  fmt::print("{}", a.json ? report.dump(1) + "\n" : text_of(report));
  return static_cast<int>(ExitCode::done);
}

}  // namespace

Action add_lightcurve(CLI::App& app) {
  auto a = std::make_shared<LightCurveArguments>();
  app.add_option("JOB", a->job,
                 "the first digits of the job's hash, a folder with snapshots (of both the last "
                 "one is taken), or a snapshot (.hdf5)")
      ->required();
  add_database(app, a->database);
  app.add_option("--remnant", a->rank, "by its rank in mass")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--aspect", a->aspect_deg,
                 "angle of the line of sight to the spin axis, deg; 90: equator-on")
      ->check(CLI::Range(0.0, 90.0))
      ->capture_default_str();
  app.add_option("-o,--output", a->picture,
                 "draw into this file (.svg, .png, .pdf), with tables (.csv) beside it");
  add_json(app, a->json);
  return [a] { return show_light_curve(*a); };
}

}  // namespace eerie::cli
