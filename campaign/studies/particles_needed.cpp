#include "campaign/studies/particles_needed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace eerie::studies {

namespace {

/// Mean b/a and mass of the largest remnant and whether there is an EER, or those of them that
/// are known.
struct Target {
  std::optional<double> b_over_a, m_1;
  std::optional<bool> eer;
};

bool is_near(const statistics::Ensemble& e, std::optional<double> target, double bound) {
  return !target || (e.runs > 0 && std::abs(e.mean - *target) <= bound);
}

/// Half of the runs decide nothing.
bool is_as_often(double p_top3_eer, std::optional<bool> eer) {
  return !eer || (*eer ? p_top3_eer > 0.5 : p_top3_eer < 0.5);
}

/// What is compared with a target.
struct Measured {
  std::int64_t particles_per_target;
  statistics::Ensemble b_over_a, m_1;
  double p_top3_eer;
};
Measured at_end(const ConvergenceCell& c) {
  return {c.particles_per_target, c.b_over_a, c.m_1, c.p_top3_eer};
}
Measured at_published(const ConvergenceCell& c) {
  return c.at_published.m_1.runs == 0 ? at_end(c)
                                      : Measured{c.particles_per_target, c.at_published.b_over_a,
                                                 c.at_published.m_1, c.at_published.p_top3_eer};
}

/// The least particle number of `rungs`, which rise, from which on all are near the target.
std::optional<std::int64_t> least_from(std::span<const ConvergenceCell> rungs, const Target& target,
                                       Measured (*measured)(const ConvergenceCell&)) {
  std::optional<std::int64_t> from;
  for (std::size_t k = rungs.size(); k-- > 0;) {
    const Measured m = measured(rungs[k]);
    if (!is_near(m.b_over_a, target.b_over_a, b_over_a_within) ||
        !is_near(m.m_1, target.m_1, m_1_within) || !is_as_often(m.p_top3_eer, target.eer))
      break;
    from = m.particles_per_target;
  }
  return from;
}

/// Variance of b/a of a single run: of the seeds of all particle numbers together.
std::optional<double> seed_variance(std::span<const ConvergenceCell> rungs) {
  double squares = 0, freedom = 0;
  for (const ConvergenceCell& rung : rungs) {
    if (rung.b_over_a.runs < 2) continue;
    const auto more = static_cast<double>(rung.b_over_a.runs - 1);
    squares += more * rung.b_over_a.deviation * rung.b_over_a.deviation;
    freedom += more;
  }
  if (freedom == 0) return {};
  return squares / freedom;
}

/// The standard error of the mean that fewest runs make.
std::optional<double> least_sure(std::span<const ConvergenceCell> rungs,
                                 std::optional<double> variance) {
  std::size_t fewest = 0;
  for (const ConvergenceCell& rung : rungs)
    if (const std::size_t runs = rung.b_over_a.runs; runs > 0)
      fewest = fewest == 0 ? runs : std::min(fewest, runs);
  if (!variance || fewest == 0) return {};
  return std::sqrt(*variance / static_cast<double>(fewest));
}

/// Least squares of the means against N^(-1/3), each weighted by its runs. A run's variance is
/// that of the seeds or of the scatter about the line, whichever is larger.
std::optional<Limit> limit_of(std::span<const ConvergenceCell> rungs,
                              std::optional<double> variance) {
  struct Point {
    double x, y, weight;
  };
  std::vector<Point> points;
  for (const ConvergenceCell& rung : rungs)
    if (rung.b_over_a.runs > 0)
      points.push_back({1 / std::cbrt(static_cast<double>(rung.particles_per_target)),
                        rung.b_over_a.mean, static_cast<double>(rung.b_over_a.runs)});
  if (points.size() < 3) return {};
  double weights = 0, mean_x = 0, mean_y = 0, xx = 0, xy = 0, rest = 0;
  for (const Point& p : points) weights += p.weight;
  for (const Point& p : points) {
    mean_x += p.weight * p.x / weights;
    mean_y += p.weight * p.y / weights;
  }
  for (const Point& p : points) {
    xx += p.weight * (p.x - mean_x) * (p.x - mean_x);
    xy += p.weight * (p.x - mean_x) * (p.y - mean_y);
  }
  const double slope = xy / xx, intercept = mean_y - slope * mean_x;
  for (const Point& p : points) rest += p.weight * std::pow(p.y - intercept - slope * p.x, 2);
  const double of_line = rest / (static_cast<double>(points.size()) - 2);
  const double of_run = std::max(of_line, variance.value_or(0));
  return Limit{intercept, std::sqrt(of_run * (1 / weights + mean_x * mean_x / xx))};
}

std::string text(std::optional<std::int64_t> number) {
  return number ? fmt::format("{}", *number) : "";
}

}  // namespace

std::vector<ParticlesNeeded> particles_needed(const ConvergenceStudy& study,
                                              const std::vector<ConvergenceCell>& cells) {
  std::vector<ParticlesNeeded> all;
  for (const ConvergenceStudy::Case& one : study.cases)
    for (const std::string& scheme : study.schemes) {
      std::vector<ConvergenceCell> rungs;
      for (const ConvergenceCell& cell : cells)
        if (cell.case_name == one.name && cell.scheme == scheme) rungs.push_back(cell);
      if (rungs.empty()) continue;
      std::ranges::sort(rungs, {}, &ConvergenceCell::particles_per_target);
      const ConvergenceCell& finest = rungs.back();
      Target own;
      if (finest.b_over_a.runs > 0) own.b_over_a = finest.b_over_a.mean;
      own.m_1 = finest.m_1.mean;
      const Target published{one.published.b_over_a, one.published.m_1_over_m_total,
                             one.published.eer};
      const std::optional<double> variance = seed_variance(rungs);
      ParticlesNeeded needed;
      needed.case_name = one.name, needed.scheme = scheme;
      needed.finest = finest.particles_per_target;
      needed.known_to = least_sure(rungs, variance);
      needed.b_over_a = limit_of(rungs, variance);
      if (rungs.size() > 1) needed.own = least_from(rungs, own, at_end);
      needed.has_published = published.b_over_a || published.m_1 || published.eer;
      if (needed.has_published) needed.published = least_from(rungs, published, at_published);
      all.push_back(std::move(needed));
    }
  return all;
}

std::string particles_needed_csv(const std::vector<ParticlesNeeded>& all) {
  std::string csv =
      "case,scheme,finest_particles_per_target,own_from,published_from,b_over_a_known_to,"
      "b_over_a_limit,b_over_a_limit_error\n";
  for (const ParticlesNeeded& r : all) {
    csv += fmt::format("{},{},{},{},{},{},", r.case_name, r.scheme, r.finest, text(r.own),
                       text(r.published), r.known_to ? fmt::format("{:.3g}", *r.known_to) : "");
    csv += r.b_over_a ? fmt::format("{:.4g},{:.3g}\n", r.b_over_a->value, r.b_over_a->error)
                      : std::string(",\n");
  }
  return csv;
}

}  // namespace eerie::studies
