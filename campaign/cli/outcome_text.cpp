#include "campaign/cli/outcome_text.hpp"

#include <fmt/format.h>

#include "campaign/cli/text_table.hpp"

namespace eerie::cli {

std::string outcome_text(const Analysis& a) {
  std::string text = fmt::format("{}: M_lr/M = {:.3f}, M_slr/M = {:.3f}\n", name(a.outcome),
                                 a.m_lr_over_m_total, a.m_slr_over_m_total);
  if (!a.settled) text += "not settled: " + a.unsettled_reason + "\n";
  if (a.remnants.empty())
    return text + fmt::format("no remnant of at least {} particles\n", remnant_min_particles);
  std::vector<std::vector<std::string>> rows = {{"remnant", "particles", "M/M_total", "a m", "b m",
                                                 "c m", "b/a", "c/a", "period h", "from target",
                                                 "EER"}};
  for (const Remnant& r : a.remnants)
    rows.push_back({fmt::format("{}", r.rank), fmt::format("{}", r.particles),
                    fmt::format("{:.3f}", r.mass_over_total), fmt::format("{:.1f}", r.shape.a),
                    fmt::format("{:.1f}", r.shape.b), fmt::format("{:.1f}", r.shape.c),
                    fmt::format("{:.3f}", r.shape.b_over_a()),
                    fmt::format("{:.3f}", r.shape.c_over_a()),
                    r.spin_period ? fmt::format("{:.2f}", *r.spin_period / 3600) : "-",
                    fmt::format("{:.2f}", r.target_fraction), r.eer ? "yes" : ""});
  return text + "\n" + text_table(rows);
}

}  // namespace eerie::cli
