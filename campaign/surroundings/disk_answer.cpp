#include "campaign/surroundings/disk_answer.hpp"

#include <fmt/format.h>

#include "analysis/disk/disk_figure.hpp"
#include "analysis/disk/friction.hpp"
#include "analysis/disk/roche.hpp"
#include "campaign/surroundings/disk_tables.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/file.hpp"

namespace eerie::surroundings {
namespace fs = std::filesystem;
using disk::astronomical_unit;

namespace {

disk::DragLaw law_of(const DiskQuestion& q) {
  if (!q.drag)
    return has_published_drag(q.body) ? disk::DragLaw::published : disk::DragLaw::weidenschilling;
  drag_of(*q.drag, disk::hayashi_nebula(astronomical_unit), q.body);  // does it know the body?
  return *q.drag;
}

nlohmann::json to_json(const disk::Nebula& n) {
  return {{"r_au", n.r / astronomical_unit},
          {"gas_kg_per_m2", n.gas_surface_density},
          {"solids_kg_per_m2", n.solid_surface_density},
          {"gas_density_kg_per_m3", n.gas_density},
          {"temperature_K", n.temperature},
          {"sound_speed_m_per_s", n.sound_speed},
          {"head_wind_m_per_s", n.head_wind},
          {"mean_free_path_m", n.mean_free_path},
          {"omega_k_per_s", n.omega_k}};
}

}  // namespace

DiskAnswer disk_answer(const DiskQuestion& q) {
  law_of(q);
  DiskAnswer answer;
  answer.nebula = disk::hayashi_nebula(q.r_au * astronomical_unit);
  answer.places = places_at(answer.nebula, q.place());
  answer.mu_d = disk::friction_coefficient(radians(q.phi_d_deg));
  answer.displacement_over_radius = disk::displacement_over_radius(answer.mu_d);
  answer.displacement_over_radius_of_sphere = disk::displacement_over_radius_of_sphere(answer.mu_d);
  answer.roche_distance = disk::roche_distance(q.b_over_a);
  answer.published = disk::published_numbers();
  return answer;
}

nlohmann::json to_json(const DiskAnswer& a) {
  return {{"nebula", to_json(a.nebula)},
          {"places", text::records(table_of_places(a.places))},
          {"mu_d", a.mu_d},
          {"displacement_over_radius", a.displacement_over_radius},
          {"displacement_over_radius_of_sphere", a.displacement_over_radius_of_sphere},
          {"roche_distance_in_radii", a.roche_distance},
          {"paper", text::records(table_of_published(a.published))}};
}

std::vector<std::string> warnings(const DiskAnswer& answer) {
  std::vector<std::string> all;
  for (const disk::Place& p : answer.places)
    if (p.t_s_omega_k < 10)
      all.push_back(
          fmt::format("Omega t_s = {:.2g} by the {} drag: the speeds hold for bodies that the gas "
                      "stops slowly, Omega t_s above 10",
                      p.t_s_omega_k, name(p.law)));
  return all;
}

std::vector<fs::path> write_disk(const DiskQuestion& q, const DiskAnswer& answer,
                                 const fs::path& folder, const std::vector<std::string>& formats) {
  const disk::DragLaw law = law_of(q);
  const double low = q.nearest_au * astronomical_unit, high = q.farthest_au * astronomical_unit;
  const disk::DiskFigure turbulence = turbulence_figure(law, q.body, low, high);
  const disk::DiskFigure stirring = stirring_figure(law, q.body, q.place().stirrers, low, high);
  std::vector<fs::path> files = {folder / "numbers.csv", folder / "turbulence.csv",
                                 folder / "stirring.csv"};
  install_text(files[0], published_numbers_csv(answer.published));
  install_text(files[1], contours_csv(turbulence.laws, "alpha", turbulence.y_unit));
  install_text(files[2], contours_csv(stirring.laws, "stirrer_radius_km", stirring.y_unit));
  for (const std::string& format : formats) {
    files.push_back(folder / ("turbulence." + format));
    draw_disk(files.back(), turbulence);
    files.push_back(folder / ("stirring." + format));
    draw_disk(files.back(), stirring);
  }
  return files;
}

}  // namespace eerie::surroundings
