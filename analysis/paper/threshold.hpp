#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace eerie::paper {

/// The runs of one impact. They differ in their seeds.
struct RidgeCell {
  double v_imp_cm_per_s = 0, theta_imp_deg = 0;
  std::vector<double> b_over_a;  ///< of the largest remnant of each run; 1 where there is none

  /// Fraction of the runs whose largest remnant is extremely elongated; 0 without runs.
  double p_largest_eer() const;
  double mean_b_over_a() const;
  double shear_speed() const;  ///< v sin(theta), cm/s
};

/// The range of sampled values at which elongated remnants form, and the next sampled values
/// outside it.
struct RidgeBound {
  double low = 0, high = 0;
  std::optional<double> below, above;  ///< nothing where no value was sampled
};

/// The ridge at one angle.
struct RidgeRow {
  double theta_imp_deg = 0;
  std::size_t speeds = 0;  ///< number of sampled speeds
  double weight = 0;       ///< sum of P(EER) dv, cm/s
  double v_centre = 0;     ///< mean speed, weighted by P(EER) dv, cm/s
  bool open = false;  ///< the first or last sampled speed makes EERs, so the centre is not known
  double lowest_b_over_a = 1;  ///< least mean b/a of any speed
  /// Speed of least b/a, by a parabola; nothing at an end of the row.
  std::optional<double> valley;
};

/// The fit v sin(theta) = constant to the elongated remnants of a map.
struct Threshold {
  double constant = 0;       ///< cm/s
  double low = 0, high = 0;  ///< interval of 95 % of the bootstrap samples, cm/s
  double deviation = 0;      ///< of v sin(theta) along the ridge, cm/s
  RidgeBound v_imp,
      theta_imp;       ///< cm/s and deg; of impacts where at least half of the runs make an EER
  double success = 0;  ///< critical success index of the band (below)
  std::optional<double> valley;  ///< mean v sin(theta) of the rows' least b/a
  std::size_t valley_rows = 0;   ///< number of rows in that mean
  /// Relative scatter of v sin(theta) over the centres of closed rows.
  std::optional<double> scatter_s;
  std::optional<double> scatter_v;  ///< relative scatter of v alone
  std::vector<RidgeRow> rows;       ///< rows with an EER, by angle

  /// The half-width of a uniform band that has the deviation of the ridge, cm/s.
  double half_width() const;
};

struct TooFewForThreshold {
  std::string reason;  ///< "needs impacts that leave at least 4 ...; there are 2 ..."
};

/// P(EER) summed over impacts, that is, the mean number of EERs in a map with one seed. It does not
/// depend on the number of seeds.
inline constexpr double threshold_min_eers = 4;
inline constexpr std::size_t threshold_min_angles = 2;

/// Fits the constant for one mass ratio, friction angle and fidelity. There is at most one cell per
/// (v, theta), in any order. Cells without runs are ignored.
///
/// P(EER) is a function of s = v sin(theta), up to the first sampled v and theta beyond all EERs.
/// The constant is its centroid, the integral of s P(s) over that of P(s). The integrals use the
/// cells in order of s, and each cell extends half-way to its neighbours. So the result depends
/// neither on how densely a part of the map is sampled nor on where rows end. The interval is the
/// percentile bootstrap of `samples` draws of cells, and of runs in each, from a generator with
/// this seed.
///
/// `success` is the fraction of runs that make an EER and lie in the band constant +- half-width
/// within the bounds, among all runs that do at least one of the two.
std::variant<Threshold, TooFewForThreshold> fit_threshold(std::vector<RidgeCell> cells,
                                                          std::size_t samples = 2000,
                                                          std::uint64_t seed = 1);

/// The ridge of equal bodies in Sugiura et al. (2019), cm/s: 5.1 at 40 deg (Fig. 2b) and 7.4 at 50
/// deg (Fig. 4). Nothing elsewhere.
std::optional<double> published_threshold(double q, double phi_d_deg);

}  // namespace eerie::paper
