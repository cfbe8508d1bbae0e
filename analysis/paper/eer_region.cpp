#include "analysis/paper/eer_region.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "analysis/paper/threshold.hpp"
#include "analysis/statistics/ensemble.hpp"
#include "solver/base/constants.hpp"

namespace eerie::paper {

namespace {

double p_of(const EerTrials& t) {
  return t.runs == 0 ? 0 : static_cast<double>(t.eers) / static_cast<double>(t.runs);
}
double log_s(double v, double theta_deg) { return std::log(v * std::sin(radians(theta_deg))); }

/// Mean and deviation, weighted by P(EER).
struct Spread {
  double weight = 0, sum = 0, squares = 0;
  void add(double p, double value) { weight += p, sum += p * value, squares += p * value * value; }
  double mean() const { return sum / weight; }
  double deviation() const { return std::sqrt(std::max(squares / weight - mean() * mean(), 0.0)); }
};

/// Whether the surface can tell anything.
bool tells_enough(const std::vector<EerTrials>& impacts) {
  double sum = 0;
  std::set<double> speeds, angles;
  for (const EerTrials& t : impacts) {
    sum += p_of(t);
    if (t.eers > 0) speeds.insert(t.v_imp_cm_per_s), angles.insert(t.theta_imp_deg);
  }
  return sum >= threshold_min_eers && speeds.size() >= 2 && angles.size() >= threshold_min_angles;
}

/// As many impacts, drawn with replacement, each with its runs. (Drawing runs as well would count
/// their scatter twice.)
std::vector<statistics::Trials> drawn(const std::vector<statistics::Trials>& from,
                                      std::mt19937_64& random) {
  std::vector<statistics::Trials> trials;
  for (std::size_t k = 0; k < from.size(); ++k) trials.push_back(from[random() % from.size()]);
  return trials;
}

/// Draws of the bootstrap; fewer for maps of very many impacts, whose surfaces are surer.
std::size_t draws_for(std::size_t impacts) {
  return std::clamp<std::size_t>(200'000 / impacts, 40, 400);
}

}  // namespace

std::array<double, 2> EerRegion::place(double v, double theta_deg) const {
  return {(log_s(v, theta_deg) - centre_s_) / width_s_, (std::log(v) - centre_v_) / width_v_};
}

EerRegion::Probability EerRegion::at(double v, double theta_deg) const {
  const auto [x, y] = place(v, theta_deg);
  std::vector<double> p;
  for (const statistics::LogisticSurface& draw : draws_) p.push_back(draw.p(x, y));
  std::ranges::sort(p);
  return {best_.p(x, y), statistics::quantile(p, 0.16), statistics::quantile(p, 0.84)};
}

std::optional<EerRegion> eer_region(const std::vector<EerTrials>& all, std::uint64_t seed) {
  std::vector<EerTrials> impacts = all;
  std::erase_if(impacts, [](const EerTrials& t) { return !(t.theta_imp_deg > 0); });
  if (!tells_enough(impacts)) return std::nullopt;
  EerRegion region;
  Spread s, v;
  for (const EerTrials& t : impacts) {
    s.add(p_of(t), log_s(t.v_imp_cm_per_s, t.theta_imp_deg));
    v.add(p_of(t), std::log(t.v_imp_cm_per_s));
  }
  region.centre_s_ = s.mean(), region.centre_v_ = v.mean();
  // All on one curve would make no width; a hundredth is less than maps resolve.
  region.width_s_ = std::max(s.deviation(), 0.01), region.width_v_ = std::max(v.deviation(), 0.01);
  std::vector<statistics::Trials> trials;
  for (const EerTrials& t : impacts) {
    if (t.runs == 0) continue;
    const auto [x, y] = region.place(t.v_imp_cm_per_s, t.theta_imp_deg);
    trials.push_back({x, y, static_cast<double>(t.eers), static_cast<double>(t.runs)});
  }
  region.best_ = statistics::fit_logistic_surface(trials);
  std::mt19937_64 random(seed);
  for (std::size_t k = 0; k < draws_for(trials.size()); ++k)
    region.draws_.push_back(statistics::fit_logistic_surface(drawn(trials, random)));
  return region;
}

}  // namespace eerie::paper
