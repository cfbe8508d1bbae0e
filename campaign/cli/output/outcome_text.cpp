#include "campaign/cli/output/outcome_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "campaign/cli/output/text_table.hpp"

namespace eerie::cli {
namespace {

/// "r_p 250 m, e 0.40, 3.2 h" of a bound remnant, "r_p 250 m, v_inf 3.1 cm/s" of an unbound one.
std::string orbit_text(const std::optional<remnants::Orbit>& orbit) {
  if (!orbit) return "-";
  const std::string text =
      fmt::format("r_p {:.0f} m, e {:.2f}", orbit->pericentre, orbit->eccentricity);
  return orbit->bound() ? text
                        : text + fmt::format(", v_inf {:.1f} cm/s",
                                             100 * std::sqrt(2 * orbit->specific_energy));
}

std::string details_table(const remnants::Analysis& a) {
  std::vector<std::vector<std::string>> rows = {{"remnant", "shape", "neck", "box m", "box b/a",
                                                 "kg/m^3", "spin tilt deg", "from depth m",
                                                 "orbit about remnant 1"}};
  for (std::size_t k = 0; k < a.details.size(); ++k) {
    const remnants::RemnantDetails& d = a.details[k];
    rows.push_back({fmt::format("{}", k + 1), std::string(shapes::name(d.shape_class)),
                    fmt::format("{:.2f}", d.neck),
                    fmt::format("{:.0f} x {:.0f} x {:.0f}", d.box.a, d.box.b, d.box.c),
                    fmt::format("{:.3f}", d.box.b_over_a()), fmt::format("{:.0f}", d.bulk_density),
                    d.tilt ? fmt::format("{:.0f}", *d.tilt) : "-",
                    d.depth ? fmt::format("{:.0f} ({:.0f} to {:.0f})", d.depth->mean, d.depth->p10,
                                          d.depth->p90)
                            : "-",
                    orbit_text(d.orbit)});
  }
  return text_table(rows);
}

}  // namespace

std::string outcome_text(const remnants::Analysis& a) {
  std::string text =
      fmt::format("{}: M_lr/M = {:.3f}, M_slr/M = {:.3f}\n", remnants::name(a.outcome),
                  a.m_lr_over_m_total, a.m_slr_over_m_total);
  if (!a.settled) text += "not settled: " + a.unsettled_reason + "\n";
  if (a.remnants.empty())
    return text +
           fmt::format("no remnant of at least {} particles\n", remnants::remnant_min_particles);
  std::vector<std::vector<std::string>> rows = {{"remnant", "particles", "M/M_total", "a m", "b m",
                                                 "c m", "b/a", "c/a", "period h", "from target",
                                                 "EER"}};
  for (const remnants::Remnant& r : a.remnants)
    rows.push_back({fmt::format("{}", r.rank), fmt::format("{}", r.particles),
                    fmt::format("{:.3f}", r.mass_over_total), fmt::format("{:.1f}", r.shape.a),
                    fmt::format("{:.1f}", r.shape.b), fmt::format("{:.1f}", r.shape.c),
                    fmt::format("{:.3f}", r.shape.b_over_a()),
                    fmt::format("{:.3f}", r.shape.c_over_a()),
                    r.spin_period ? fmt::format("{:.2f}", *r.spin_period / 3600) : "-",
                    fmt::format("{:.2f}", r.target_fraction), r.eer ? "yes" : ""});
  text += "\n" + text_table(rows);
  return a.details.empty() ? text : text + "\n" + details_table(a);
}

}  // namespace eerie::cli
