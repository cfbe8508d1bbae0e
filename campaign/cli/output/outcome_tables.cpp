#include "campaign/cli/output/outcome_tables.hpp"

#include "analysis/remnants/remnants.hpp"

namespace eerie::cli {

void add_outcome(Answer& answer, const nlohmann::json& analysis) {
  const nlohmann::json& outcome = analysis.at("outcome");
  answer.say("{}: M_lr/M = {:.3f}, M_slr/M = {:.3f}\n", outcome.at("class").get<std::string>(),
             outcome.at("m_lr_over_m_total").get<double>(),
             outcome.at("m_slr_over_m_total").get<double>());
  if (!outcome.at("settled").get<bool>())
    answer.say("not settled: {}\n", outcome.at("unsettled_reason").get<std::string>());
  const nlohmann::json& remnants = analysis.at("remnants");
  if (remnants.empty()) {
    answer.say("no remnant of at least {} particles\n", remnants::remnant_min_particles);
    return;
  }
  answer.say("\n");
  answer.add(chosen(remnants,
                    {both("rank", "remnant"), both("particles", "particles"),
                     both("mass_over_total", "M/M_total", "{:.3f}"), both("a_m", "a m", "{:.1f}"),
                     both("b_m", "b m", "{:.1f}"), both("c_m", "c m", "{:.1f}"),
                     both("b_over_a", "b/a", "{:.3f}"), both("c_over_a", "c/a", "{:.3f}"),
                     both("spin_period_h", "period h", "{:.2f}"),
                     both("target_fraction", "from target", "{:.2f}"), both("eer", "EER")}));
  if (!remnants.front().contains("shape_class")) return;
  answer.say("\n");
  answer.add(chosen(
      remnants,
      {both("rank", "remnant"), both("shape_class", "shape"), both("neck", "neck", "{:.2f}"),
       both("box_a_m", "box a m", "{:.0f}"), both("box_b_m", "b m", "{:.0f}"),
       both("box_c_m", "c m", "{:.0f}"), both("box_b_over_a", "box b/a", "{:.3f}"),
       both("bulk_density_kg_per_m3", "kg/m^3", "{:.0f}"),
       both("spin_tilt_deg", "spin tilt deg", "{:.0f}"),
       both("origin_depth_mean_m", "from depth m", "{:.0f}"),
       both("orbit_pericentre_m", "orbit r_p m", "{:.0f}"),
       both("orbit_eccentricity", "e", "{:.2f}"), both("orbit_period_h", "orbit h", "{:.1f}"),
       both("orbit_v_inf_m_per_s", "v_inf m/s", "{:.3f}")}));
}

}  // namespace eerie::cli
