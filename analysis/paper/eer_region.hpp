#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/statistics/logistic_surface.hpp"

namespace eerie::paper {

/// The runs of one impact, and how many of them left an EER as the largest remnant.
struct EerTrials {
  double v_imp_cm_per_s = 0, theta_imp_deg = 0;
  std::size_t eers = 0, runs = 0;
};

/// P(EER) as a smooth function of speed and angle: a logistic surface over ln(v sin theta) and
/// ln v, across the ridge and along it. The interval is the percentile bootstrap over impacts.
class EerRegion {
 public:
  struct Probability {
    double p = 0, low = 0, high = 0;  ///< most likely, and 68 % of the bootstrap draws
  };
  /// v > 0 and 0 < theta < 180 deg.
  Probability at(double v_imp_cm_per_s, double theta_imp_deg) const;

 private:
  friend std::optional<EerRegion> eer_region(const std::vector<EerTrials>&, std::uint64_t);
  std::array<double, 2> place(double v_imp_cm_per_s, double theta_imp_deg) const;

  double centre_s_ = 0, width_s_ = 1, centre_v_ = 0, width_v_ = 1;  ///< of the ridge, logarithms
  statistics::LogisticSurface best_;
  std::vector<statistics::LogisticSurface> draws_;
};

/// Fits the region. Nothing where P(EER) summed over the impacts is below 4, or where all EERs have
/// one speed or one angle. Head-on impacts are left out: they have no ln(v sin theta).
std::optional<EerRegion> eer_region(const std::vector<EerTrials>& impacts, std::uint64_t seed = 1);

}  // namespace eerie::paper
