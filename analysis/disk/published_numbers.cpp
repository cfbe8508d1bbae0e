#include "analysis/disk/published_numbers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analysis/disk/ejection.hpp"
#include "analysis/disk/encounter_speed.hpp"
#include "analysis/disk/friction.hpp"
#include "analysis/disk/roche.hpp"
#include "solver/base/bodies/sphere.hpp"
#include "solver/base/constants.hpp"

namespace eerie::disk {

namespace {

using Numbers = std::vector<PublishedNumber>;

Nebula at_au(double au) { return hayashi_nebula(au * astronomical_unit); }

double dimensionless(const Nebula& nebula, const Drag& drag) {
  return drag.stopping_time * nebula.omega_k;
}

/// Omega t_s by one law of a fluid, or Epstein's, continued to 1 AU: by Weidenschilling's drag at
/// `au`, where that law holds, and the slope that the law has in Hayashi's nebula.
double at_1_au(double au, double slope) {
  const Nebula n = at_au(au);
  return dimensionless(n, weidenschilling_drag(n, published_body)) * std::pow(au, -slope);
}

/// Where one regime of Weidenschilling's drag ends and the next begins, AU: by bisection.
double edge_au(DragRegime inner, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    (weidenschilling_drag(at_au(middle), published_body).regime == inner ? low : high) = middle;
  }
  return low;
}

/// The slope of Omega t_s over the distance.
double slope_at(double au) {
  constexpr double step = 1.001;
  const auto log_time = [](double r) {
    const Nebula n = at_au(r);
    return std::log(dimensionless(n, weidenschilling_drag(n, published_body)));
  };
  return (log_time(au * step) - log_time(au / step)) / (2 * std::log(step));
}

void add_drag(Numbers& list) {
  const std::string eq6 = "sec. 4.1, Eq. (6)";
  list.insert(list.end(),
              {{"t_s Omega, r > 19 AU: factor", "1", eq6, 2.2e1, 2, {}, at_1_au(30, 1.5)},
               {"t_s Omega, 1.6 to 19 AU: factor", "1", eq6, 3.6e3, 2, {}, at_1_au(5, -0.25)},
               {"t_s Omega, r < 1.6 AU: factor", "1", eq6, 1.8e3, 2, {}, at_1_au(0.5, 1.25)},
               {"t_s Omega, r > 19 AU: slope", "1", eq6, 1.5, 2, {}, slope_at(30)},
               {"t_s Omega, 1.6 to 19 AU: slope", "1", eq6, -0.25, 2, {}, slope_at(5)},
               {"t_s Omega, r < 1.6 AU: slope", "1", eq6, 1.25, 3, {}, slope_at(0.5)},
               // Where the printed pieces cross.
               {"edge of Epstein's law", "AU", eq6, 19, 2, std::pow(3.6e3 / 2.2e1, 1 / 1.75),
                edge_au(DragRegime::stokes, 16.5, 40)},
               {"edge of Newton's law", "AU", eq6, 1.6, 2, std::pow(3.6e3 / 1.8e3, 1 / 1.5),
                edge_au(DragRegime::newton, 0.5, 5)}});
}

/// A number by both laws of drag.
template <class ValueBy>
PublishedNumber by_both(PublishedNumber number, const ValueBy& value_by) {
  number.by_formulas = value_by(DragLaw::published);
  number.by_nebula = value_by(DragLaw::weidenschilling);
  return number;
}

double alpha_limit(DragLaw law, double au) {
  const Nebula n = at_au(au);
  return alpha_at_speed(n, drag_of(law, n, published_body), fast);
}

double stirrer_limit_km(DragLaw law, double au) {
  const Nebula n = at_au(au);
  return stirrer_radius_at_speed(n, drag_of(law, n, published_body), {}, fast) / 1000;
}

void add_speeds(Numbers& list) {
  for (const double au : {1.0, 5.0, 10.0, 20.0})
    list.push_back(by_both(
        {fmt::format("alpha for 40 cm/s at {:g} AU", au), "1", "sec. 4.1, Fig. 7", 5e-4, 1, {}, {}},
        [au](DragLaw law) { return alpha_limit(law, au); }));
  list.push_back(by_both(
      {"alpha for 40 cm/s beyond 20 AU: slope", "1", "sec. 4.1", 2, 1, {}, {}}, [](DragLaw law) {
        return std::log(alpha_limit(law, 100) / alpha_limit(law, 25)) / std::log(4.0);
      }));
  list.push_back(by_both({"R for 40 cm/s at 1 AU", "km", "sec. 4.2, Fig. 8", 2, 1, {}, {}},
                         [](DragLaw law) { return stirrer_limit_km(law, 1); }));
  list.push_back(by_both({"R for 40 cm/s beyond 20 AU", "km", "sec. 4.2, Fig. 8", 7, 1, {}, {}},
                         [](DragLaw law) { return stirrer_limit_km(law, 40); }));
}

void add_bodies(Numbers& list) {
  constexpr double target = 50, rho = 2700, cohesion = 1000, quoted_pressure = 10;
  constexpr double jupiter_distance = 5.2044 * astronomical_unit, jupiter_radius = 7.1492e7;
  constexpr double jupiter_mass = 1 / 1047.35;  // of the Sun's
  const double p_c = central_pressure({target, rho});
  list.insert(
      list.end(),
      {{"slowest useful impact over 10 km/s", "1", "sec. 4", 1e-5, 1, slow / 1e4, {}},
       {"mu_d L/R_r", "1", "sec. 3.2, Eq. (5)", 1, 1, displacement_over_radius_of_sphere(1), {}},
       {"phi_d where L/R_r = 1",
        "deg",
        "sec. 3.2",
        45,
        2,
        degrees(std::atan(displacement_over_radius_of_sphere(1))),
        {}},
       {"central pressure, R = 50 m", "Pa", "sec. 4, Eq. (3)", 10, 1, p_c, {}},
       {"v_imp with 1 kPa of cohesion over without",
        "1",
        "sec. 4",
        10,
        1,
        std::sqrt(cohesion / p_c),
        {}},
       {"the same from the quoted 10 Pa",
        "1",
        "sec. 4",
        10,
        1,
        std::sqrt(cohesion / quoted_pressure),
        {}},
       {"d_R/R_c, b/a = 0.1", "1", "sec. 4.3, Eq. (14)", 3.2, 2, roche_distance(0.1), {}},
       {"limit around an equal binary", "a_b", "sec. 4.3", 2.4, 2, circumbinary_limit(0.5, 0), {}},
       {"Jupiter's Hill radius",
        "R_J",
        "sec. 4.3",
        740,
        2,
        hill_radius(jupiter_distance, jupiter_mass) / jupiter_radius,
        {}}});
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

}  // namespace

bool agrees(const PublishedNumber& number, double value) {
  const double last_digit =
      std::pow(10, std::floor(std::log10(std::abs(number.paper))) - number.digits + 1);
  return std::abs(value - number.paper) <= last_digit / 2 * (1 + 1e-9);
}

std::vector<PublishedNumber> published_numbers() {
  Numbers list;
  add_drag(list);
  add_speeds(list);
  add_bodies(list);
  return list;
}

std::string published_numbers_csv(const std::vector<PublishedNumber>& numbers) {
  std::string text = "quantity,unit,paper,by_its_formulas,by_nebula,agrees,source\n";
  for (const PublishedNumber& n : numbers)
    text += fmt::format("\"{}\",{},{:g},{},{},{},\"{}\"\n", n.quantity, n.unit, n.paper,
                        cell(n.by_formulas), cell(n.by_nebula), agrees(n, n.computed()), n.source);
  return text;
}

}  // namespace eerie::disk
