#include <algorithm>

#include "analysis/disk/disk_figure.hpp"
#include "analysis/disk/friction.hpp"
#include "analysis/disk/roche.hpp"
#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/disk_report.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/queries/numbers.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/file.hpp"

namespace eerie::cli {
namespace {
namespace fs = std::filesystem;
using eerie::disk::Body;
using eerie::disk::DragLaw;
using eerie::disk::Nebula;
using eerie::disk::Place;
using eerie::disk::PublishedNumber;
using eerie::disk::Stirrers;

struct DiskArguments {
  double r_au = 5, alpha = 1e-4, stirrer_radius_km = 2;
  Body body;
  double solid_fraction = Stirrers().solid_fraction;
  double phi_d_deg = 40, b_over_a = 0.24;
  std::string drag;  ///< empty: published where it knows the body
  std::string r_range = "1:100";
  fs::path folder;  ///< empty: nothing is drawn
  std::vector<std::string> formats = {"svg"};

  Stirrers stirrers() const { return {solid_fraction, body.density}; }
};

/// Options with their ranges; the example is a good value.
struct Limit {
  const char* option;
  double DiskArguments::*value;
  double low, high, example;
  const char* unit;
};
constexpr double nearest_au = 0.05, farthest_au = 1000;
constexpr Limit limits[] = {
    {"--r", &DiskArguments::r_au, nearest_au, farthest_au, 5, " AU"},
    {"--alpha", &DiskArguments::alpha, 1e-10, 1, 1e-4, ""},
    {"--stirrer-radius", &DiskArguments::stirrer_radius_km, 0.01, 3000, 2, " km"},
    {"--solid-fraction", &DiskArguments::solid_fraction, 1e-6, 1, 0.01, ""},
    {"--phi-d", &DiskArguments::phi_d_deg, 1, 89, 40, " deg"},
    {"--b-over-a", &DiskArguments::b_over_a, 0.01, 1, 0.24, ""}};

void require(const char* option, double value, double low, double high, double example,
             const char* unit) {
  if (value >= low && value <= high) return;
  throw InputError(fmt::format("{0} = {1:g}: must be {2:g} to {3:g}{4}; for example {0} {5:g}",
                               option, value, low, high, unit, example));
}

db::Range checked(const DiskArguments& a) {
  for (const Limit& l : limits) require(l.option, a.*l.value, l.low, l.high, l.example, l.unit);
  require("--radius", a.body.radius, 0.1, 1e6, 100, " m");
  require("--density", a.body.density, 100, 1e4, 2700, " kg/m^3");
  const db::Range r = queries::parse_range(a.r_range, "--r-range");
  require("--r-range (LO)", r.lo, nearest_au, farthest_au / 2, 1, " AU");
  if (r.hi < 2 * r.lo || r.hi > farthest_au)
    throw InputError(
        fmt::format("--r-range {}: HI must be {:g} (twice LO) to {:g} AU; for example "
                    "--r-range {:g}:{:g}",
                    a.r_range, 2 * r.lo, farthest_au, r.lo, std::min(100 * r.lo, farthest_au)));
  return r;
}

DragLaw law_of(const DiskArguments& a) {
  if (a.drag.empty())
    return has_published_drag(a.body) ? DragLaw::published : DragLaw::weidenschilling;
  const DragLaw law = disk::drag_law(a.drag);
  drag_of(law, disk::hayashi_nebula(disk::astronomical_unit), a.body);  // does it know the body?
  return law;
}

std::vector<fs::path> write_all(const DiskArguments& a, const db::Range& r_au,
                                const std::vector<PublishedNumber>& numbers) {
  const DragLaw law = law_of(a);
  const double low = r_au.lo * disk::astronomical_unit, high = r_au.hi * disk::astronomical_unit;
  const disk::DiskFigure turbulence = turbulence_figure(law, a.body, low, high);
  const disk::DiskFigure stirring = stirring_figure(law, a.body, a.stirrers(), low, high);
  std::vector<fs::path> files = {a.folder / "numbers.csv", a.folder / "turbulence.csv",
                                 a.folder / "stirring.csv"};
  text::make_given_folder(a.folder);
  install_text(files[0], published_numbers_csv(numbers));
  install_text(files[1], contours_csv(turbulence.laws, "alpha", turbulence.y_unit));
  install_text(files[2], contours_csv(stirring.laws, "stirrer_radius_km", stirring.y_unit));
  for (const std::string& format : a.formats) {
    files.push_back(a.folder / ("turbulence." + format));
    draw_disk(files.back(), turbulence);
    files.push_back(a.folder / ("stirring." + format));
    draw_disk(files.back(), stirring);
  }
  return files;
}

void warn(const std::vector<Place>& places) {
  for (const Place& p : places)
    if (p.t_s_omega_k < 10)
      print_warnings(
          {fmt::format("Omega t_s = {:.2g} by the {} drag: the speeds hold for bodies "
                       "that the gas stops slowly, Omega t_s above 10",
                       p.t_s_omega_k, name(p.law))});
}

Answer disk_environment(const DiskArguments& a) {
  const db::Range r_au = checked(a);
  law_of(a);
  const Nebula nebula = disk::hayashi_nebula(a.r_au * disk::astronomical_unit);
  const disk::PlaceQuestion question{a.body, a.stirrers(), a.alpha, 1000 * a.stirrer_radius_km};
  const std::vector<Place> places = places_at(nebula, question);
  const std::vector<PublishedNumber> numbers = disk::published_numbers();
  const double mu_d = disk::friction_coefficient(radians(a.phi_d_deg));
  const std::vector<fs::path> files =
      a.folder.empty() ? std::vector<fs::path>{} : write_all(a, r_au, numbers);
  warn(places);
  const double shift = disk::displacement_over_radius(mu_d);
  const double of_sphere = disk::displacement_over_radius_of_sphere(mu_d);
  const double roche = disk::roche_distance(a.b_over_a);
  Table published = table_of_published(numbers);
  Answer answer;
  answer.data = {{"nebula", to_json(nebula)},
                 {"places", records(table_of_places(places))},
                 {"mu_d", mu_d},
                 {"displacement_over_radius", shift},
                 {"displacement_over_radius_of_sphere", of_sphere},
                 {"roche_distance_in_radii", roche},
                 {"paper", records(published)},
                 {"files", names_of(files)}};
  answer.add_text(nebula_line(nebula) + "\n");
  answer.add(turned_table_of_places(a.r_au, question, places));
  answer.say(
      "\nphi_d = {:g} deg: mu_d = {:.3g}, L/R_r ~ 1/mu_d = {:.3g} ({:.3g} for a sphere)\n"
      "b/a = {:g}: tides deform it within {:.3g} radii of a body of its density\n\n",
      a.phi_d_deg, mu_d, shift, of_sphere, a.b_over_a, roche);
  answer.add(std::move(published));
  answer.add_files(files);
  return answer;
}

}  // namespace

Action add_disk(CLI::App& app) {
  auto a = std::make_shared<DiskArguments>();
  app.add_option("--r", a->r_au, "distance from the star, AU")->capture_default_str();
  app.add_option("--alpha", a->alpha, "strength of turbulence")->capture_default_str();
  app.add_option("--stirrer-radius", a->stirrer_radius_km, "radius R of large planetesimals, km")
      ->capture_default_str();
  app.add_option("--solid-fraction", a->solid_fraction, "part of all solids that is in them")
      ->capture_default_str();
  app.add_option("--radius", a->body.radius, "radius of the small bodies, m")
      ->capture_default_str();
  app.add_option("--density", a->body.density, "of all bodies, kg/m^3")->capture_default_str();
  app.add_option("--drag", a->drag,
                 "published or weidenschilling (default: published where it is known, for bodies "
                 "of 100 m and 2700 kg/m^3)")
      ->check(CLI::IsMember({"published", "weidenschilling"}));
  app.add_option("--phi-d", a->phi_d_deg, "friction angle, deg")->capture_default_str();
  app.add_option("--b-over-a", a->b_over_a, "axis ratio of a remnant")->capture_default_str();
  app.add_option("--r-range", a->r_range, "distances of the figures LO:HI, AU")
      ->capture_default_str();
  app.add_option("-o,--output", a->folder, "folder for figures and their numbers");
  app.add_option("--format", a->formats, "svg, png or pdf; may be repeated")
      ->check(CLI::IsMember({"svg", "png", "pdf"}))
      ->allow_extra_args(false)
      ->capture_default_str();
  add_formats(app);
  return [a](Output&) { return disk_environment(*a); };
}

}  // namespace eerie::cli
