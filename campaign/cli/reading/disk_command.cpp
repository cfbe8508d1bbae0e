#include <algorithm>

#include "campaign/cli/options/command_list.hpp"
#include "campaign/cli/output/files.hpp"
#include "campaign/queries/numbers.hpp"
#include "campaign/surroundings/disk_answer.hpp"
#include "campaign/surroundings/disk_tables.hpp"

namespace eerie::cli {
namespace {
using surroundings::DiskQuestion;

struct DiskArguments {
  DiskQuestion question;
  std::string drag, r_range = "1:100";
  std::filesystem::path folder;  ///< empty: nothing is drawn
  std::vector<std::string> formats = {"svg"};
};

constexpr double nearest_au = 0.05, farthest_au = 1000;

/// A validator that says the range and a good value.
CLI::Validator within(const char* option, double low, double high, double example,
                      const char* unit = "") {
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        const double value = queries::finite_number(text).value_or(high + 1);
        if (value >= low && value <= high) return "";
        throw InputError(
            fmt::format("{0} = {1:g}: must be {2:g} to {3:g}{4}; for example {0} {5:g}", option,
                        value, low, high, unit, example));
      },
      "");
}

DiskQuestion question_of(const DiskArguments& a) {
  DiskQuestion q = a.question;
  if (!a.drag.empty()) q.drag = disk::drag_law(a.drag);
  const db::Range r = queries::parse_range(a.r_range, "--r-range");
  within("--r-range (LO)", nearest_au, farthest_au / 2, 1, " AU")(fmt::format("{}", r.lo));
  if (r.hi < 2 * r.lo || r.hi > farthest_au)
    throw InputError(
        fmt::format("--r-range {}: HI must be {:g} (twice LO) to {:g} AU; for example "
                    "--r-range {:g}:{:g}",
                    a.r_range, 2 * r.lo, farthest_au, r.lo, std::min(100 * r.lo, farthest_au)));
  q.nearest_au = r.lo, q.farthest_au = r.hi;
  return q;
}

Answer disk_environment(const DiskArguments& a) {
  const DiskQuestion q = question_of(a);
  const surroundings::DiskAnswer found = surroundings::disk_answer(q);
  std::vector<std::filesystem::path> files;
  if (!a.folder.empty()) {
    text::make_given_folder(a.folder);
    files = surroundings::write_disk(q, found, a.folder, a.formats);
  }
  print_warnings(surroundings::warnings(found));
  Answer answer;
  answer.data = surroundings::to_json(found);
  answer.data["files"] = names_of(files);
  answer.add_text(surroundings::nebula_line(found.nebula) + "\n");
  answer.add(surroundings::turned_table_of_places(q, found.places));
  answer.say(
      "\nphi_d = {:g} deg: mu_d = {:.3g}, L/R_r ~ 1/mu_d = {:.3g} ({:.3g} for a sphere)\n"
      "b/a = {:g}: tides deform it within {:.3g} radii of a body of its density\n\n",
      q.phi_d_deg, found.mu_d, found.displacement_over_radius,
      found.displacement_over_radius_of_sphere, q.b_over_a, found.roche_distance);
  answer.add(surroundings::table_of_published(found.published));
  answer.add_files(files);
  return answer;
}

}  // namespace

Action add_disk(CLI::App& app) {
  auto a = std::make_shared<DiskArguments>();
  DiskQuestion& q = a->question;
  const auto number = [&](const char* option, double& value, const char* help, double low,
                          double high, double example, const char* unit = "") {
    app.add_option(option, value, help)
        ->check(within(option, low, high, example, unit))
        ->capture_default_str();
  };
  number("--r", q.r_au, "distance from the star, AU", nearest_au, farthest_au, 5, " AU");
  number("--alpha", q.alpha, "strength of turbulence", 1e-10, 1, 1e-4);
  number("--stirrer-radius", q.stirrer_radius_km, "radius R of large planetesimals, km", 0.01, 3000,
         2, " km");
  number("--solid-fraction", q.solid_fraction, "part of all solids that is in them", 1e-6, 1, 0.01);
  number("--radius", q.body.radius, "radius of the small bodies, m", 0.1, 1e6, 100, " m");
  number("--density", q.body.density, "of all bodies, kg/m^3", 100, 1e4, 2700, " kg/m^3");
  number("--phi-d", q.phi_d_deg, "friction angle, deg", 1, 89, 40, " deg");
  number("--b-over-a", q.b_over_a, "axis ratio of a remnant", 0.01, 1, 0.24);
  app.add_option("--drag", a->drag,
                 "published or weidenschilling (default: published where it is known, for bodies "
                 "of 100 m and 2700 kg/m^3)")
      ->check(CLI::IsMember({"published", "weidenschilling"}));
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
