#include "campaign/reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace eerie {

namespace {

/// Mean b/a and mass of the largest remnant, or those of them that there are.
struct Target {
  std::optional<double> b_over_a, m_1;
};

bool is_near(const Ensemble& e, std::optional<double> target, double bound) {
  return !target || (e.runs > 0 && std::abs(e.mean - *target) <= bound);
}

/// The least particle number of `rungs`, which rise, from which on all are near the target.
std::optional<std::int64_t> reached(std::span<const StudyCell> rungs, const Target& target) {
  std::optional<std::int64_t> from;
  for (std::size_t k = rungs.size(); k-- > 0;) {
    if (!is_near(rungs[k].b_over_a, target.b_over_a, b_over_a_within) ||
        !is_near(rungs[k].m_1, target.m_1, m_1_within))
      break;
    from = rungs[k].particles_per_target;
  }
  return from;
}

/// Least squares of the means against N^(-1/3), each as sure as the next; the scatter about the
/// line, not that of seeds, makes its error.
std::optional<Limit> limit_of(std::span<const StudyCell> rungs) {
  std::vector<std::pair<double, double>> points;
  for (const StudyCell& rung : rungs)
    if (rung.b_over_a.runs > 0)
      points.emplace_back(1 / std::cbrt(static_cast<double>(rung.particles_per_target)),
                          rung.b_over_a.mean);
  if (points.size() < 3) return {};
  const auto n = static_cast<double>(points.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, rest = 0;
  for (const auto& [x, y] : points) mean_x += x / n, mean_y += y / n;
  for (const auto& [x, y] : points) {
    xx += (x - mean_x) * (x - mean_x);
    xy += (x - mean_x) * (y - mean_y);
  }
  const double slope = xy / xx, intercept = mean_y - slope * mean_x;
  for (const auto& [x, y] : points) rest += std::pow(y - intercept - slope * x, 2);
  return Limit{intercept, std::sqrt(rest / (n - 2) * (1 / n + mean_x * mean_x / xx))};
}

std::string text(std::optional<std::int64_t> number) {
  return number ? fmt::format("{}", *number) : "";
}

}  // namespace

std::vector<Reach> reaches_of(const Study& study, const std::vector<StudyCell>& cells) {
  std::vector<Reach> reaches;
  for (const Study::Case& one : study.cases)
    for (const std::string& scheme : study.schemes) {
      std::vector<StudyCell> rungs;
      for (const StudyCell& cell : cells)
        if (cell.case_name == one.name && cell.scheme == scheme) rungs.push_back(cell);
      if (rungs.empty()) continue;
      std::ranges::sort(rungs, {}, &StudyCell::particles_per_target);
      const StudyCell& finest = rungs.back();
      Target own;
      if (finest.b_over_a.runs > 0) own.b_over_a = finest.b_over_a.mean;
      own.m_1 = finest.m_1.mean;
      const Target published{one.published.b_over_a, one.published.m_1_over_m_total};
      Reach reach{one.name, scheme, finest.particles_per_target, {}, {}, false, limit_of(rungs)};
      if (rungs.size() > 1) reach.own = reached(rungs, own);
      reach.has_published = published.b_over_a || published.m_1;
      if (reach.has_published) reach.published = reached(rungs, published);
      reaches.push_back(std::move(reach));
    }
  return reaches;
}

std::string reaches_csv(const std::vector<Reach>& reaches) {
  std::string csv =
      "case,scheme,finest_particles_per_target,own_from,published_from,b_over_a_limit,"
      "b_over_a_limit_error\n";
  for (const Reach& r : reaches) {
    csv += fmt::format("{},{},{},{},{},", r.case_name, r.scheme, r.finest, text(r.own),
                       text(r.published));
    csv += r.b_over_a ? fmt::format("{:.4g},{:.3g}\n", r.b_over_a->value, r.b_over_a->error)
                      : std::string(",\n");
  }
  return csv;
}

}  // namespace eerie
