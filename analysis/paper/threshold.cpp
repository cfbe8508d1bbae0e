#include "analysis/paper/threshold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>

#include "analysis/remnants/remnants.hpp"
#include "analysis/statistics/ensemble.hpp"
#include "analysis/statistics/map_axis.hpp"
#include "solver/base/constants.hpp"

namespace eerie::paper {

namespace {

bool is_eer(double b_over_a) { return b_over_a < remnants::eer_max_b_over_a; }

/// A cell with the part of the axis of s that it stands for.
struct Weighted {
  const RidgeCell* cell = nullptr;
  double s = 0, width = 0;
};

/// The first value above `limit`, else the limit itself.
double next_above(const std::set<double>& values, double limit) {
  const auto next = values.upper_bound(limit);
  return next == values.end() ? limit : *next;
}

std::set<double> all(const std::vector<RidgeCell>& cells, double RidgeCell::*value) {
  std::set<double> values;
  for (const RidgeCell& cell : cells) values.insert(cell.*value);
  return values;
}

/// The cells up to the first speed and angle beyond all EERs, by s.
std::vector<Weighted> along_s(const std::vector<RidgeCell>& cells) {
  double v_top = 0, theta_top = 0;
  for (const RidgeCell& cell : cells)
    if (cell.p_largest_eer() > 0) {
      v_top = std::max(v_top, cell.v_imp_cm_per_s);
      theta_top = std::max(theta_top, cell.theta_imp_deg);
    }
  v_top = next_above(all(cells, &RidgeCell::v_imp_cm_per_s), v_top);
  theta_top = next_above(all(cells, &RidgeCell::theta_imp_deg), theta_top);
  std::vector<Weighted> line;
  for (const RidgeCell& cell : cells)
    if (cell.v_imp_cm_per_s <= v_top && cell.theta_imp_deg <= theta_top)
      line.push_back({&cell, cell.shear_speed(), 0});
  std::ranges::sort(line, {}, &Weighted::s);
  for (std::size_t i = 0; i < line.size() && line.size() > 1; ++i) {
    const double before = i > 0 ? line[i].s - line[i - 1].s : line[i + 1].s - line[i].s;
    const double after = i + 1 < line.size() ? line[i + 1].s - line[i].s : before;
    line[i].width = (before + after) / 2;
  }
  return line;
}

/// Sums over cells of width P(EER) s^k.
struct Moments {
  double zeroth = 0, first = 0, second = 0;
  void add(double weight, double s) {
    zeroth += weight, first += weight * s, second += weight * s * s;
  }
  double mean() const { return first / zeroth; }
  double deviation() const { return std::sqrt(std::max(second / zeroth - mean() * mean(), 0.0)); }
};

Moments moments(const std::vector<Weighted>& line) {
  Moments sum;
  for (const Weighted& w : line) sum.add(w.width * w.cell->p_largest_eer(), w.s);
  return sum;
}

/// P(EER) of as many runs, drawn from those of a cell.
double drawn_p_largest_eer(const RidgeCell& cell, std::mt19937_64& random) {
  const std::size_t runs = cell.b_over_a.size();
  std::size_t eers = 0;
  for (std::size_t k = 0; k < runs; ++k) eers += is_eer(cell.b_over_a[random() % runs]) ? 1 : 0;
  return static_cast<double>(eers) / static_cast<double>(runs);
}

/// Sorted constants of the bootstrap; a draw without any EER has none and is left out.
std::vector<double> bootstrap(const std::vector<Weighted>& line, std::size_t samples,
                              std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<double> constants;
  for (std::size_t k = 0; k < samples; ++k) {
    Moments sum;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Weighted& w = line[random() % line.size()];
      sum.add(w.width * drawn_p_largest_eer(*w.cell, random), w.s);
    }
    if (sum.zeroth > 0) constants.push_back(sum.mean());
  }
  std::ranges::sort(constants);
  return constants;
}

RidgeBound bound(const std::vector<RidgeCell>& cells, double RidgeCell::*value) {
  const std::set<double> sampled = all(cells, value);
  std::set<double> inside;
  for (const RidgeCell& cell : cells)
    if (cell.p_largest_eer() >= 0.5) inside.insert(cell.*value);
  RidgeBound b{*inside.begin(), *inside.rbegin(), {}, {}};
  const auto low = sampled.find(b.low), above = sampled.upper_bound(b.high);
  if (low != sampled.begin()) b.below = *std::prev(low);
  if (above != sampled.end()) b.above = *above;
  return b;
}

/// Where the parabola through three points has its least value; x ascending, the middle y least.
double vertex(const double (&x)[3], const double (&y)[3]) {
  const double left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[2] - y[1]) / (x[2] - x[1]);
  const double curvature = (right - left) / (x[2] - x[0]);
  if (!(curvature > 0)) return x[1];
  return (x[0] + x[1]) / 2 - left / (2 * curvature);
}

std::optional<double> valley(const std::vector<const RidgeCell*>& row) {
  const auto least = std::ranges::min_element(row, {}, &RidgeCell::mean_b_over_a);
  if (least == row.begin() || least + 1 == row.end() || !is_eer((*least)->mean_b_over_a()))
    return std::nullopt;
  double x[3], y[3];
  for (int k = 0; k < 3; ++k) {
    const RidgeCell& cell = **(least + k - 1);
    x[k] = cell.v_imp_cm_per_s, y[k] = cell.mean_b_over_a();
  }
  return vertex(x, y);
}

/// One angle; `row` by speed.
RidgeRow ridge_row(const std::vector<const RidgeCell*>& row) {
  std::vector<double> speeds;
  speeds.reserve(row.size());
  for (const RidgeCell* cell : row) speeds.push_back(cell->v_imp_cm_per_s);
  const statistics::MapAxis axis = statistics::map_axis(speeds);
  RidgeRow r;
  r.theta_imp_deg = row.front()->theta_imp_deg, r.speeds = row.size();
  Moments sum;
  for (std::size_t k = 0; k < row.size(); ++k) {
    sum.add((axis.edges[k + 1] - axis.edges[k]) * row[k]->p_largest_eer(), speeds[k]);
    r.lowest_b_over_a = std::min(r.lowest_b_over_a, row[k]->mean_b_over_a());
  }
  r.weight = sum.zeroth;
  r.v_centre = sum.zeroth > 0 ? sum.mean() : 0;
  r.open = row.front()->p_largest_eer() > 0 || row.back()->p_largest_eer() > 0;
  r.valley = valley(row);
  return r;
}

std::vector<RidgeRow> ridge_rows(const std::vector<RidgeCell>& cells) {
  std::map<double, std::vector<const RidgeCell*>> by_angle;
  for (const RidgeCell& cell : cells) by_angle[cell.theta_imp_deg].push_back(&cell);
  std::vector<RidgeRow> rows;
  for (auto& [theta, row] : by_angle) {
    std::ranges::sort(row, {}, &RidgeCell::v_imp_cm_per_s);
    const RidgeRow r = ridge_row(row);
    if (r.weight > 0) rows.push_back(r);
  }
  return rows;
}

/// Do the rows tell v sin(theta) = const from v = const?
void compare_rows(Threshold& t) {
  Moments s, v;
  double valleys = 0;
  std::size_t closed = 0;
  for (const RidgeRow& row : t.rows) {
    const double sine = std::sin(radians(row.theta_imp_deg));
    if (row.valley) valleys += *row.valley * sine, ++t.valley_rows;
    if (row.open) continue;
    ++closed;
    s.add(row.weight, row.v_centre * sine), v.add(row.weight, row.v_centre);
  }
  if (t.valley_rows > 0) t.valley = valleys / static_cast<double>(t.valley_rows);
  if (closed < 2) return;
  t.scatter_s = s.deviation() / s.mean();
  t.scatter_v = v.deviation() / v.mean();
}

double success(const std::vector<RidgeCell>& cells, const Threshold& t) {
  double hits = 0, either = 0;
  for (const RidgeCell& cell : cells) {
    const bool inside = std::abs(cell.shear_speed() - t.constant) <= t.half_width() &&
                        cell.v_imp_cm_per_s <= t.v_imp.high &&
                        cell.theta_imp_deg <= t.theta_imp.high;
    for (const double b_over_a : cell.b_over_a) {
      hits += inside && is_eer(b_over_a) ? 1 : 0;
      either += inside || is_eer(b_over_a) ? 1 : 0;
    }
  }
  return hits / either;
}

/// Why a constant would be a number from nothing; empty where it is not.
std::string what_lacks(const std::vector<RidgeCell>& cells, const std::vector<Weighted>& line) {
  double eers = 0;
  std::set<double> angles;
  for (const RidgeCell& cell : cells) {
    eers += cell.p_largest_eer();
    if (cell.p_largest_eer() >= 0.5) angles.insert(cell.theta_imp_deg);
  }
  if (eers < threshold_min_eers || angles.size() < threshold_min_angles)
    return fmt::format(
        "needs impacts that leave at least {:g} extremely elongated largest remnants with a seed "
        "each, at {} angles where half of the runs of one do; there are {:.3g} at {} {}, of {} "
        "impacts with results",
        threshold_min_eers, threshold_min_angles, eers, angles.size(),
        angles.size() == 1 ? "angle" : "angles", cells.size());
  for (const Weighted* end : {&line.front(), &line.back()})
    if (end->cell->p_largest_eer() >= 0.5)
      return fmt::format(
          "needs impacts without elongated remnants on both sides of the ridge; at v sin(theta) = "
          "{:.2f} cm/s (v = {:g} cm/s, theta = {:g} deg), the {} sampled, they still form",
          end->s, end->cell->v_imp_cm_per_s, end->cell->theta_imp_deg,
          end == &line.front() ? "least" : "greatest");
  return "";
}

}  // namespace

double RidgeCell::p_largest_eer() const {
  if (b_over_a.empty()) return 0;
  return static_cast<double>(std::ranges::count_if(b_over_a, is_eer)) /
         static_cast<double>(b_over_a.size());
}

double RidgeCell::mean_b_over_a() const {
  return std::accumulate(b_over_a.begin(), b_over_a.end(), 0.0) /
         static_cast<double>(b_over_a.size());
}

double RidgeCell::shear_speed() const { return v_imp_cm_per_s * std::sin(radians(theta_imp_deg)); }

double Threshold::half_width() const { return std::sqrt(3.0) * deviation; }

std::variant<Threshold, TooFewForThreshold> fit_threshold(std::vector<RidgeCell> cells,
                                                          std::size_t samples, std::uint64_t seed) {
  std::erase_if(cells, [](const RidgeCell& cell) { return cell.b_over_a.empty(); });
  // In this order draws of the bootstrap do not depend on the caller's.
  std::ranges::sort(cells, {}, [](const RidgeCell& cell) {
    return std::pair(cell.theta_imp_deg, cell.v_imp_cm_per_s);
  });
  const std::vector<Weighted> line = along_s(cells);
  if (const std::string lacking = what_lacks(cells, line); !lacking.empty())
    return TooFewForThreshold{lacking};
  Threshold t;
  const Moments ridge = moments(line);
  t.constant = ridge.mean(), t.deviation = ridge.deviation();
  const std::vector<double> constants = bootstrap(line, samples, seed);
  t.low = statistics::quantile(constants, 0.025), t.high = statistics::quantile(constants, 0.975);
  t.v_imp = bound(cells, &RidgeCell::v_imp_cm_per_s);
  t.theta_imp = bound(cells, &RidgeCell::theta_imp_deg);
  t.success = success(cells, t);
  t.rows = ridge_rows(cells);
  compare_rows(t);
  return t;
}

std::optional<double> published_threshold(double q, double phi_d_deg) {
  if (q != 1) return std::nullopt;
  if (phi_d_deg == 40) return 5.1;
  if (phi_d_deg == 50) return 7.4;
  return std::nullopt;
}

}  // namespace eerie::paper
