#include "campaign/surroundings/disk_tables.hpp"

#include <fmt/format.h>

namespace eerie::surroundings {
using disk::Nebula, disk::Place, disk::PublishedNumber;
using text::both, text::data, text::or_null, text::shown;
using text::Table, text::table_of;

Table table_of_places(const std::vector<Place>& places) {
  return table_of<Place>(
      {{data("drag"), [](const Place& p) { return name(p.law); }},
       {data("regime"), [](const Place& p) { return name(p.drag.regime); }},
       {data("t_s_s"), [](const Place& p) { return p.drag.stopping_time; }},
       {data("t_s_omega_k"), [](const Place& p) { return p.t_s_omega_k; }},
       {data("turbulent_speed_cm_per_s"), [](const Place& p) { return 100 * p.turbulent_speed; }},
       {data("stirred_speed_cm_per_s"), [](const Place& p) { return 100 * p.stirred_speed; }},
       {data("alpha_at_15_cm_per_s"), [](const Place& p) { return p.alpha_slow; }},
       {data("alpha_at_40_cm_per_s"), [](const Place& p) { return p.alpha_fast; }},
       {data("stirrer_radius_km_at_15_cm_per_s"),
        [](const Place& p) { return p.stirrer_radius_slow / 1000; }},
       {data("stirrer_radius_km_at_40_cm_per_s"),
        [](const Place& p) { return p.stirrer_radius_fast / 1000; }}},
      places);
}

std::string nebula_line(const Nebula& n) {
  return fmt::format(
      "Hayashi's nebula at {:g} AU: gas {:.4g} kg/m^2, solids {:.3g} kg/m^2, {:.3g} K, sound "
      "{:.4g} m/s, head wind {:.3g} m/s, mean free path {:.3g} m\n",
      n.r / disk::astronomical_unit, n.gas_surface_density, n.solid_surface_density, n.temperature,
      n.sound_speed, n.head_wind, n.mean_free_path);
}

Table turned_table_of_places(const DiskQuestion& q, const std::vector<Place>& places) {
  std::vector<std::vector<std::string>> rows = {
      {fmt::format("bodies of {:g} m at {:g} AU", q.body.radius, q.r_au)},
      {"law of drag"},
      {"Omega t_s"},
      {fmt::format("speed in turbulence, alpha = {:g}", q.alpha)},
      {fmt::format("speed among bodies of {:g} km", q.stirrer_radius_km)},
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
  const std::vector<std::string> headers = rows.front();
  rows.erase(rows.begin());
  return text::words(headers, rows);
}

Table table_of_published(const std::vector<PublishedNumber>& numbers) {
  const auto computed = [](const PublishedNumber& n) {
    return agrees(n, n.computed()) ? "agrees" : fmt::format("x {:.2f}", n.computed() / n.paper);
  };
  return table_of<PublishedNumber>(
      {{both("quantity", "Sugiura et al. (2019)"),
        [](const PublishedNumber& n) { return n.quantity; }},
       {both("unit", "unit"), [](const PublishedNumber& n) { return n.unit; }},
       {both("paper", "paper", "{:g}"), [](const PublishedNumber& n) { return n.paper; }},
       {both("by_its_formulas", "its formulas", "{:.3g}"),
        [](const PublishedNumber& n) { return or_null(n.by_formulas); }},
       {both("by_nebula", "nebula", "{:.3g}"),
        [](const PublishedNumber& n) { return or_null(n.by_nebula); }},
       {data("agrees"), [](const PublishedNumber& n) { return agrees(n, n.computed()); }},
       {shown(""), computed},
       {both("source", "source"), [](const PublishedNumber& n) { return n.source; }}},
      numbers);
}

}  // namespace eerie::surroundings
