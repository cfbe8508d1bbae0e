#include "campaign/maps/eer_fit.hpp"

#include <algorithm>

#include "analysis/statistics/map_axis.hpp"

namespace eerie::maps {

namespace {

std::vector<double> even(double low, double high, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t k = 0; k < count; ++k)
    values[k] = low + (high - low) * static_cast<double>(k) / static_cast<double>(count - 1);
  return values;
}

paper::EerTrials trials_at(const db::MapPoint& p) {
  return {p.v_imp_cm_per_s, p.theta_imp_deg, static_cast<std::size_t>(p.largest_is_eer),
          static_cast<std::size_t>(p.results)};
}

}  // namespace

bool same_map(const db::MapPoint& a, const db::MapPoint& b) {
  return a.q == b.q && a.phi_d_deg == b.phi_d_deg && a.settings == b.settings;
}

std::vector<std::optional<paper::EerRegion>> eer_regions(const std::vector<db::MapPoint>& points) {
  std::vector<std::optional<paper::EerRegion>> regions;
  for (auto first = points.begin(); first != points.end();) {
    const auto last = std::find_if_not(first, points.end(),
                                       [&](const db::MapPoint& p) { return same_map(p, *first); });
    std::vector<paper::EerTrials> impacts;
    std::transform(first, last, std::back_inserter(impacts), trials_at);
    regions.push_back(paper::eer_region(impacts));
    first = last;
  }
  return regions;
}

diagrams::EerBorders borders_of(const paper::EerRegion& region, const diagrams::PhaseDiagram& map) {
  std::vector<double> speeds, angles;
  for (const diagrams::PhaseCell& cell : map.cells)
    speeds.push_back(cell.v_imp_cm_per_s), angles.push_back(cell.theta_imp_deg);
  // The edges of the outermost cells may lie at zero or below, where no impact is.
  constexpr double least = 1e-3;
  const auto axis = [&](const std::vector<double>& at, std::size_t count) {
    const std::vector<double> edges = statistics::map_axis(at).edges;
    return even(std::max(edges.front(), least), edges.back(), count);
  };
  const auto v = axis(speeds, 120), theta = axis(angles, 90);
  std::vector<double> p, low, high;
  for (const double angle : theta)
    for (const double speed : v) {
      const paper::EerRegion::Probability here = region.at(speed, angle);
      p.push_back(here.p), low.push_back(here.low), high.push_back(here.high);
    }
  diagrams::EerBorders borders{statistics::isolines(v, theta, p, 0.5),
                               statistics::isolines(v, theta, low, 0.5)};
  std::ranges::copy(statistics::isolines(v, theta, high, 0.5), std::back_inserter(borders.ends));
  return borders;
}

}  // namespace eerie::maps
