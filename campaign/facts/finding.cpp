#include "campaign/facts/finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "analysis/paper/threshold.hpp"
#include "analysis/remnants/remnants.hpp"
#include "solver/base/constants.hpp"

namespace eerie::facts {

namespace {

/// v sin(theta) of an impact, cm/s.
double tangential_speed(double v_imp_cm_per_s, double theta_imp_deg) {
  return v_imp_cm_per_s * std::sin(theta_imp_deg * pi / 180);
}

/// The impacts of one mass ratio and friction angle: v, theta, and whether a run of it made an EER.
using Impacts = std::map<std::pair<double, double>, bool>;

std::string speeds_of(const Impacts& impacts) {
  double low = INFINITY, high = 0;
  for (const auto& [impact, elongated] : impacts) {
    if (!elongated) continue;
    const double speed = tangential_speed(impact.first, impact.second);
    low = std::min(low, speed), high = std::max(high, speed);
  }
  return low == high ? fmt::format("{:.1f}", low) : fmt::format("{:.1f} to {:.1f}", low, high);
}

std::string sentence(const Impacts& impacts, std::optional<double> published) {
  const auto elongated = std::ranges::count_if(impacts, [](const auto& i) { return i.second; });
  std::string text =
      elongated == 0
          ? fmt::format("none of {} impacts makes an extremely elongated remnant (b/a < {:g})",
                        impacts.size(), remnants::eer_max_b_over_a)
          : fmt::format(
                "{} of {} impacts make an extremely elongated remnant (b/a < {:g}), at v "
                "sin(theta) "
                "= {} cm/s",
                elongated, impacts.size(), remnants::eer_max_b_over_a, speeds_of(impacts));
  if (published) text += fmt::format("; the paper has them along {:g} cm/s", *published);
  return text;
}

}  // namespace

std::vector<std::string> finding(const std::vector<db::ResultRow>& rows) {
  std::map<std::tuple<double, double, std::int64_t>, Impacts> groups;
  std::set<std::int64_t> settings;
  for (const db::ResultRow& row : rows) {
    bool& elongated =
        groups[{row.q, row.phi_d_deg, row.settings}][{row.v_imp_cm_per_s, row.theta_imp_deg}];
    elongated = elongated || row.result.n_eer > 0;
    settings.insert(row.settings);
  }
  std::vector<std::string> sentences;
  for (const auto& [point, impacts] : groups) {
    const auto [q, phi_d, of] = point;
    std::string where = groups.size() > 1 ? fmt::format("q {:g}, phi_d {:g} deg", q, phi_d) : "";
    if (settings.size() > 1) where += fmt::format(", settings {}", of);
    if (!where.empty()) where += ": ";
    sentences.push_back(where + sentence(impacts, paper::published_threshold(q, phi_d)));
  }
  return sentences;
}

}  // namespace eerie::facts
