#include "campaign/cli/output/disk_report.hpp"

#include <fmt/format.h>

#include <optional>

#include "campaign/cli/output/text_table.hpp"

namespace eerie::cli {
using eerie::disk::Nebula;
using eerie::disk::Place;
using eerie::disk::PublishedNumber;
using nlohmann::json;

json to_json(const Place& p) {
  return {{"drag", name(p.law)},
          {"regime", name(p.drag.regime)},
          {"t_s_s", p.drag.stopping_time},
          {"t_s_omega_k", p.t_s_omega_k},
          {"turbulent_speed_cm_per_s", 100 * p.turbulent_speed},
          {"stirred_speed_cm_per_s", 100 * p.stirred_speed},
          {"alpha_at_15_cm_per_s", p.alpha_slow},
          {"alpha_at_40_cm_per_s", p.alpha_fast},
          {"stirrer_radius_km_at_15_cm_per_s", p.stirrer_radius_slow / 1000},
          {"stirrer_radius_km_at_40_cm_per_s", p.stirrer_radius_fast / 1000}};
}

json to_json(const Nebula& n) {
  return {{"r_au", n.r / disk::astronomical_unit},
          {"gas_kg_per_m2", n.gas_surface_density},
          {"solids_kg_per_m2", n.solid_surface_density},
          {"gas_density_kg_per_m3", n.gas_density},
          {"temperature_K", n.temperature},
          {"sound_speed_m_per_s", n.sound_speed},
          {"head_wind_m_per_s", n.head_wind},
          {"mean_free_path_m", n.mean_free_path},
          {"omega_k_per_s", n.omega_k}};
}

json to_json(const PublishedNumber& n) {
  const auto value = [](const std::optional<double>& v) { return v ? json(*v) : json(nullptr); };
  return {{"quantity", n.quantity},
          {"unit", n.unit},
          {"paper", n.paper},
          {"by_its_formulas", value(n.by_formulas)},
          {"by_nebula", value(n.by_nebula)},
          {"agrees", agrees(n, n.computed())},
          {"source", n.source}};
}

std::string nebula_line(const Nebula& n) {
  return fmt::format(
      "Hayashi's nebula at {:g} AU: gas {:.4g} kg/m^2, solids {:.3g} kg/m^2, {:.3g} K, sound "
      "{:.4g} m/s, head wind {:.3g} m/s, mean free path {:.3g} m\n",
      n.r / disk::astronomical_unit, n.gas_surface_density, n.solid_surface_density, n.temperature,
      n.sound_speed, n.head_wind, n.mean_free_path);
}

std::string place_table(double r_au, const disk::PlaceQuestion& q,
                        const std::vector<Place>& places) {
  std::vector<std::vector<std::string>> rows = {
      {fmt::format("bodies of {:g} m at {:g} AU", q.body.radius, r_au)},
      {"law of drag"},
      {"Omega t_s"},
      {fmt::format("speed in turbulence, alpha = {:g}", q.alpha)},
      {fmt::format("speed among bodies of {:g} km", q.stirrer_radius / 1000)},
      {"alpha for 15 and 40 cm/s"},
      {"R for 15 and 40 cm/s"}};
  for (const Place& p : places) {
    const std::string cells[] = {name(p.law) + " drag",
                                 name(p.drag.regime),
                                 fmt::format("{:.4g}", p.t_s_omega_k),
                                 fmt::format("{:.3g} cm/s", 100 * p.turbulent_speed),
                                 fmt::format("{:.3g} cm/s", 100 * p.stirred_speed),
                                 fmt::format("{:.2e}, {:.2e}", p.alpha_slow, p.alpha_fast),
                                 fmt::format("{:.3g}, {:.3g} km", p.stirrer_radius_slow / 1000,
                                             p.stirrer_radius_fast / 1000)};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(cells[i]);
  }
  return text_table(rows);
}

std::string published_table(const std::vector<PublishedNumber>& numbers) {
  const auto number = [](const std::optional<double>& v) {
    return v ? fmt::format("{:.3g}", *v) : std::string();
  };
  std::vector<std::vector<std::string>> rows = {
      {"Sugiura et al. (2019)", "unit", "paper", "its formulas", "nebula", "", "source"}};
  for (const PublishedNumber& n : numbers)
    rows.push_back(
        {n.quantity, n.unit, fmt::format("{:g}", n.paper), number(n.by_formulas),
         number(n.by_nebula),
         agrees(n, n.computed()) ? "agrees" : fmt::format("x {:.2f}", n.computed() / n.paper),
         n.source});
  return text_table(rows);
}

}  // namespace eerie::cli
