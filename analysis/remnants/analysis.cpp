#include "analysis/remnants/analysis.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/remnants/meetings.hpp"
#include "solver/scene/tide.hpp"

namespace eerie::remnants {

namespace {

nlohmann::json to_json(const Remnant& r) {
  nlohmann::json period;  // null
  if (r.spin_period) period = *r.spin_period / 3600;
  return {{"rank", r.rank},
          {"particles", r.particles},
          {"mass_kg", r.mass},
          {"mass_over_total", r.mass_over_total},
          {"a_m", r.shape.a},
          {"b_m", r.shape.b},
          {"c_m", r.shape.c},
          {"b_over_a", r.shape.b_over_a()},
          {"c_over_a", r.shape.c_over_a()},
          {"spin_period_h", period},
          {"eer", r.eer},
          {"target_fraction", r.target_fraction},
          {"bound_group", r.bound_group},
          {"bound_mass_over_total", r.bound_mass_over_total},
          {"x_m", r.x.x},
          {"y_m", r.x.y},
          {"z_m", r.x.z},
          {"vx_m_per_s", r.v.x},
          {"vy_m_per_s", r.v.y},
          {"vz_m_per_s", r.v.z}};
}

OutcomeMasses outcome_masses(const particles::State& state,
                             const std::vector<double>& group_masses) {
  const auto in_target =
      std::ranges::count(state.body, static_cast<std::uint8_t>(particles::Body::target));
  OutcomeMasses masses;
  masses.target = state.mass * static_cast<double>(in_target);
  masses.impactor = state.mass * static_cast<double>(state.size()) - masses.target;
  if (!group_masses.empty()) masses.m_lr = group_masses[0];
  if (group_masses.size() > 1) masses.m_slr = group_masses[1];
  return masses;
}

}  // namespace

Analysis analyse(const io::Snapshot& snapshot, bool separated_after_contact) {
  Remnants found = find_remnants(snapshot.state);
  const OutcomeMasses masses = outcome_masses(snapshot.state, found.group_masses);
  const double total = masses.target + masses.impactor;
  Analysis analysis;
  analysis.outcome = classify(masses, separated_after_contact);
  analysis.m_lr_over_m_total = masses.m_lr / total;
  analysis.m_slr_over_m_total = masses.m_slr / total;
  analysis.debris_bound_over_total = found.debris_bound_mass / total;
  analysis.remnants = std::move(found.remnants);
  const double fragment = snapshot.scene.end.settled.fall_back;
  analysis.unsettled_reason = has_primary(snapshot.scene)
                                  ? unsettled_reason_in_tide(analysis.remnants, fragment)
                                  : unsettled_reason(analysis.remnants, fragment);
  analysis.settled = analysis.unsettled_reason.empty();
  return analysis;
}

Analysis analyse_in_detail(const io::Snapshot& snapshot, const io::Snapshot* first,
                           bool separated_after_contact) {
  Analysis analysis = analyse(snapshot, separated_after_contact);
  const auto depths = first != nullptr ? initial_depths(*first) : std::vector<double>{};
  analysis.details = describe_remnants(snapshot, analysis.remnants, depths);
  return analysis;
}

nlohmann::json to_json(const Analysis& analysis) {
  nlohmann::json remnants = nlohmann::json::array();
  for (std::size_t k = 0; k < analysis.remnants.size(); ++k) {
    remnants.push_back(to_json(analysis.remnants[k]));
    if (!analysis.details.empty()) remnants.back().update(to_json(analysis.details[k]));
  }
  return {{"outcome",
           {{"class", name(analysis.outcome)},
            {"m_lr_over_m_total", analysis.m_lr_over_m_total},
            {"m_slr_over_m_total", analysis.m_slr_over_m_total},
            {"settled", analysis.settled},
            {"unsettled_reason", analysis.unsettled_reason}}},
          {"remnants", std::move(remnants)}};
}

}  // namespace eerie::remnants
