#include "campaign/maps/map_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/remnants/outcome.hpp"
#include "analysis/statistics/ensemble.hpp"
#include "campaign/maps/eer_fit.hpp"
#include "campaign/text/csv.hpp"
#include "solver/base/constants.hpp"

namespace eerie::maps {

namespace {

constexpr const char* fitted_columns = ",p_eer_fit,p_eer_fit_low,p_eer_fit_high";

/// "perfect_merging_share".
std::string share_column(const remnants::OutcomeName& row) {
  std::string name(row.name);
  std::ranges::replace(name, '-', '_');
  return name + "_share";
}

std::string header() {
  std::string text =
      "q,phi_d_deg,v_imp_cm_per_s,theta_imp_deg,v_over_v_esc,v_sin_theta_cm_per_s,settings,"
      "fidelity,"
      "particles_per_target,jobs,done,failed,stale,unsettled,seeds,b_over_a,b_over_a_std,c_over_a,"
      "c_over_a_std,m_lr_over_m_total,m_lr_over_m_total_std,period_h,period_std_h,n_eer,n_eer_std,"
      "p_eer,class,class_share";
  for (const remnants::OutcomeName& row : remnants::outcome_names) text += "," + share_column(row);
  return text;
}

std::string line(const db::MapPoint& p) {
  std::string text = fmt::format("{},{},{},{},{:.6g},{:.6g},{},{},{},{},{},{},{},{},{}", p.q,
                                 p.phi_d_deg, p.v_imp_cm_per_s, p.theta_imp_deg, p.v_over_v_esc,
                                 p.v_imp_cm_per_s * std::sin(radians(p.theta_imp_deg)), p.settings,
                                 p.fidelity, p.particles_per_target, p.jobs, p.done, p.failed,
                                 p.stale, p.unsettled, p.results);
  for (const auto* numbers :
       {&p.b_over_a, &p.c_over_a, &p.m_lr_over_m_total, &p.period_h, &p.n_eer}) {
    const statistics::Ensemble e = statistics::ensemble(*numbers);
    text += fmt::format(",{},{}", text::csv_number(statistics::mean_of(e)),
                        text::csv_number(statistics::deviation_of(e)));
  }
  const auto share = [&](const std::string& outcome) -> std::optional<double> {
    if (p.results == 0) return std::nullopt;
    const auto found = p.classes.find(outcome);
    return p.share(found == p.classes.end() ? 0 : found->second);
  };
  const std::string outcome = p.outcome_class();
  text += fmt::format(",{},{},{}", p.results > 0 ? text::csv_number(p.p_largest_eer()) : "",
                      outcome, text::csv_number(share(outcome)));
  for (const remnants::OutcomeName& row : remnants::outcome_names)
    text += "," + text::csv_number(share(std::string(row.name)));
  return text;
}

std::string fitted(const std::optional<paper::EerRegion>& region, const db::MapPoint& point) {
  if (!region || point.theta_imp_deg == 0) return ",,,";  // a head-on impact has no place there
  const paper::EerRegion::Probability fit = region->at(point.v_imp_cm_per_s, point.theta_imp_deg);
  return fmt::format(",{:.4f},{:.4f},{:.4f}", fit.p, fit.low, fit.high);
}

}  // namespace

std::string map_csv(const std::vector<db::MapPoint>& points,
                    const std::vector<std::optional<paper::EerRegion>>& regions) {
  std::string text = header() + (regions.empty() ? "" : fitted_columns) + "\n";
  std::size_t map = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k > 0 && !same_map(points[k], points[k - 1])) ++map;
    text += line(points[k]);
    if (!regions.empty()) text += fitted(regions[map], points[k]);
    text += "\n";
  }
  return text;
}

}  // namespace eerie::maps
