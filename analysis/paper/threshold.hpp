#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace eerie::paper {

/// The runs of one impact, which differ in seed.
struct RidgeCell {
  double v_imp_cm_per_s = 0, theta_imp_deg = 0;
  std::vector<double> b_over_a;  ///< of each run's largest remnant; 1 where there is none

  /// Fraction of the runs whose largest remnant is extremely elongated; 0 without runs.
  double p_largest_eer() const;
  double mean_b_over_a() const;
  double shear_speed() const;  ///< v sin(theta), cm/s
};

/// Sampled values that elongated remnants come from, and the next sampled ones outside.
struct RidgeBound {
  double low = 0, high = 0;
  std::optional<double> below, above;  ///< nothing: none was sampled there
};

/// The ridge along one angle.
struct RidgeRow {
  double theta_imp_deg = 0;
  std::size_t speeds = 0;        ///< sampled
  double weight = 0;             ///< sum of P(EER) dv, cm/s
  double v_centre = 0;           ///< mean speed weighted by it, cm/s
  bool open = false;             ///< the first or last sampled speed makes EERs: centre unknown
  double lowest_b_over_a = 1;    ///< least mean of one speed
  std::optional<double> valley;  ///< speed of least b/a by a parabola; nothing at an end
};

/// v sin(theta) = constant: where a map's elongated remnants lie.
struct Threshold {
  double constant = 0;              ///< cm/s
  double low = 0, high = 0;         ///< 95 % of the bootstrap's samples of it
  double deviation = 0;             ///< of v sin(theta) along the ridge, cm/s
  RidgeBound v_imp, theta_imp;      ///< cm/s and deg, of impacts half of whose runs make an EER
  double success = 0;               ///< critical success index of the band (below)
  std::optional<double> valley;     ///< mean v sin(theta) of the rows' least b/a
  std::size_t valley_rows = 0;      ///< that it is the mean of
  std::optional<double> scatter_s;  ///< of closed rows' centres, relative: v sin(theta) ...
  std::optional<double> scatter_v;  ///< ... and v alone
  std::vector<RidgeRow> rows;       ///< with an EER, by angle

  /// A band of equal probability with this half-width has the ridge's deviation.
  double half_width() const;
};

struct TooFewForThreshold {
  std::string reason;  ///< "needs impacts that leave at least 4 ...; there are 2 ..."
};

/// P(EER) summed over impacts: what a map with one seed holds on average. More seeds do not change
/// it.
inline constexpr double threshold_min_eers = 4;
inline constexpr std::size_t threshold_min_angles = 2;

/// Fits the constant of one mass ratio, friction angle and fidelity; cells at most one per (v,
/// theta), any order, without runs ignored.
///
/// P(EER) is taken as a function of s = v sin(theta) up to the first sampled v and theta beyond
/// all EERs; the constant is its centroid, the integral of s P(s) over that of P(s) by the cells in
/// order of s, each as wide as half-way to its neighbours. So it matters neither how densely a
/// part of the map is sampled nor where rows end. The interval is the percentile bootstrap of
/// `samples` draws of cells, and of runs in each, from a generator with this seed.
///
/// Success: of all runs that either make an EER or lie in the band constant +- half-width within
/// the bounds, the part that does both.
std::variant<Threshold, TooFewForThreshold> fit_threshold(std::vector<RidgeCell> cells,
                                                          std::size_t samples = 2000,
                                                          std::uint64_t seed = 1);

/// The ridge of equal bodies in Sugiura et al. (2019), cm/s: 5.1 at 40 deg (Fig. 2b), 7.4 at 50
/// deg (Fig. 4); nothing elsewhere.
std::optional<double> published_threshold(double q, double phi_d_deg);

}  // namespace eerie::paper
