#include "campaign/surroundings/collision_odds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "analysis/disk/collisions.hpp"
#include "analysis/figures/odds_figure.hpp"
#include "solver/base/constants.hpp"

namespace eerie::surroundings {
namespace fs = std::filesystem;

namespace {

/// The cells of each axis into which a map is cut, to be summed one by one.
constexpr int cells = 200;

/// The ends of an axis and the smallest step between values on it.
struct Axis {
  double low, high, step;

  explicit Axis(const std::set<double>& values)
      : low(*values.begin()), high(*values.rbegin()), step(std::max(high - low, 1e-9)) {
    for (auto value = values.begin(), next = std::next(value); next != values.end();
         ++value, ++next)
      step = std::min(step, *next - *value);
  }
  double at(double part) const { return low + part * (high - low); }
};

/// A map with results, ready to be asked for many dispersions.
class OddsMap {
 public:
  explicit OddsMap(std::vector<db::MapPoint> points) : points_(std::move(points)) {
    std::set<double> speeds, angles;
    for (const db::MapPoint& p : points_)
      speeds.insert(p.v_imp_cm_per_s), angles.insert(p.theta_imp_deg);
    const Axis v(speeds), theta(angles);
    for (int k = 0; k <= cells; ++k) {
      const double part = static_cast<double>(k) / cells;
      v_.push_back(v.at(part)), theta_.push_back(theta.at(part));
    }
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j)
        nearest_.push_back(nearest((v_[at(i)] + v_[at(i + 1)]) / 2, v.step,
                                   (theta_[at(j)] + theta_[at(j + 1)]) / 2, theta.step));
  }

  CollisionOdds odds(double dispersion) const {
    const db::MapPoint& any = points_.front();
    const double v_esc = any.v_imp_cm_per_s / any.v_over_v_esc;
    const disk::CollisionSpeeds speeds{dispersion, v_esc};
    std::vector<double> share(points_.size());  // of all collisions, by their nearest impact
    for (int i = 0, cell = 0; i < cells; ++i) {
      const double fast = speeds.share_below(v_[at(i + 1)]) - speeds.share_below(v_[at(i)]);
      for (int j = 0; j < cells; ++j, ++cell)
        share[nearest_[at(cell)]] += fast * (disk::share_below_angle(radians(theta_[at(j + 1)])) -
                                             disk::share_below_angle(radians(theta_[at(j)])));
    }
    CollisionOdds found{any.q, any.phi_d_deg, any.fidelity, dispersion, speeds.median()};
    double variance = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const double p = points_[k].p_largest_eer();
      found.mapped += share[k];
      found.p_eer += share[k] * p;
      variance += share[k] * share[k] * p * (1 - p) / static_cast<double>(points_[k].results);
    }
    found.p_eer_error = std::sqrt(variance);
    return found;
  }

 private:
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  /// The impact nearest in units of the steps of the map.
  std::size_t nearest(double v, double v_step, double theta, double theta_step) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const double dv = (points_[k].v_imp_cm_per_s - v) / v_step,
                   dt = (points_[k].theta_imp_deg - theta) / theta_step;
      if (const double d2 = dv * dv + dt * dt; d2 < least) least = d2, best = k;
    }
    return best;
  }

  std::vector<db::MapPoint> points_;
  std::vector<double> v_, theta_;  ///< edges of the cells, cm/s and deg
  std::vector<std::size_t> nearest_;
};

bool same_map(const db::MapPoint& a, const db::MapPoint& b) {
  return a.q == b.q && a.phi_d_deg == b.phi_d_deg && a.settings == b.settings;
}

}  // namespace

std::vector<CollisionOdds> collision_odds(const std::vector<db::MapPoint>& points,
                                          const std::vector<double>& dispersions_cm_per_s) {
  std::vector<CollisionOdds> all;
  for (auto first = points.begin(); first != points.end();) {
    const auto last = std::find_if_not(first, points.end(),
                                       [&](const db::MapPoint& p) { return same_map(p, *first); });
    std::vector<db::MapPoint> known;
    std::copy_if(first, last, std::back_inserter(known),
                 [](const db::MapPoint& p) { return p.results > 0; });
    first = last;
    if (known.empty()) continue;
    const OddsMap map(std::move(known));
    for (const double dispersion : dispersions_cm_per_s) all.push_back(map.odds(dispersion));
  }
  return all;
}

std::vector<double> usual_dispersions_cm_per_s() {
  return {1,  1.5, 2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12,
          13, 14,  16, 18, 20, 22, 25, 28, 32, 40, 50, 70, 100};
}

text::Table table_of_odds(const std::vector<CollisionOdds>& odds) {
  using text::both;
  const auto number = [](const char* name, const char* header, const char* pattern,
                         double CollisionOdds::*member) {
    return text::Field<CollisionOdds>{both(name, header, pattern),
                                      [member](const CollisionOdds& o) { return o.*member; }};
  };
  return text::table_of<CollisionOdds>(
      {number("q", "q", "{:g}", &CollisionOdds::q),
       number("phi_d_deg", "phi_d deg", "{:g}", &CollisionOdds::phi_d_deg),
       {both("fidelity", "fidelity"), [](const CollisionOdds& o) { return o.fidelity; }},
       number("dispersion_cm_per_s", "dispersion cm/s", "{:g}",
              &CollisionOdds::dispersion_cm_per_s),
       number("median_v_imp_cm_per_s", "median v_imp cm/s", "{:.3g}",
              &CollisionOdds::median_v_imp_cm_per_s),
       number("p_eer", "P(EER) per collision", "{:.4f}", &CollisionOdds::p_eer),
       number("p_eer_error", "+-", "{:.4f}", &CollisionOdds::p_eer_error),
       number("mapped", "inside the map", "{:.3f}", &CollisionOdds::mapped)},
      odds);
}

void draw_odds(const fs::path& path, const std::vector<CollisionOdds>& odds) {
  std::vector<figures::OddsCurve> curves;
  for (const CollisionOdds& o : odds) {
    const std::string name = fmt::format("q = {:g}, friction {:g}°{}{}", o.q, o.phi_d_deg,
                                         o.fidelity.empty() ? "" : ", ", o.fidelity);
    if (curves.empty() || curves.back().name != name) curves.push_back({name, {}});
    curves.back().points.push_back({o.dispersion_cm_per_s, o.p_eer, o.p_eer_error});
  }
  figures::draw_odds(path, curves);
}

}  // namespace eerie::surroundings
