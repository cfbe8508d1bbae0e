#include "campaign/surroundings/collision_odds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/disk/collisions.hpp"
#include "solver/base/constants.hpp"

namespace eerie::surroundings {
namespace {

constexpr double v_esc = 6.1;

/// A map over 7 to 200 cm/s and 0 to 90 deg in which `is_eer` says the outcome of two runs each.
template <class Outcome>
std::vector<db::MapPoint> map_where(Outcome&& is_eer, double q = 1) {
  std::vector<db::MapPoint> points;
  for (double v = 7; v <= 200; v += 1)
    for (double theta = 0; theta <= 90; theta += 5) {
      db::MapPoint p;
      p.q = q, p.phi_d_deg = 40, p.v_imp_cm_per_s = v, p.theta_imp_deg = theta;
      p.v_over_v_esc = v / v_esc;
      p.results = 2, p.largest_is_eer = is_eer(v, theta);
      points.push_back(p);
    }
  return points;
}

TEST(CollisionOdds, AreThoseOfTheSpeedsWhereEveryImpactLeavesAnEer) {
  const auto odds = collision_odds(map_where([](double, double) { return 2; }), {1, 10, 30});
  ASSERT_EQ(odds.size(), 3u);
  for (const CollisionOdds& o : odds) {
    const disk::CollisionSpeeds speeds{o.dispersion_cm_per_s, v_esc};
    EXPECT_NEAR(o.p_eer, speeds.share_below(200) - speeds.share_below(7), 1e-9);
    EXPECT_NEAR(o.mapped, o.p_eer, 1e-12);
    EXPECT_EQ(o.p_eer_error, 0);
  }
}

TEST(CollisionOdds, AreTheShareOfTheAnglesAtWhichEersForm) {
  // The nearest impact changes at 17.5 and at 32.5 deg.
  const auto odds =
      collision_odds(map_where([](double, double t) { return t >= 20 && t <= 30 ? 2 : 0; }), {20});
  const double angles =
      disk::share_below_angle(radians(32.5)) - disk::share_below_angle(radians(17.5));
  EXPECT_NEAR(odds.at(0).p_eer, odds.at(0).mapped * angles, 5e-3);
}

TEST(CollisionOdds, HaveAnErrorWhereSeedsDisagree) {
  const auto odds = collision_odds(map_where([](double, double) { return 1; }), {20});
  EXPECT_NEAR(odds.at(0).p_eer, odds.at(0).mapped / 2, 1e-9);
  EXPECT_GT(odds.at(0).p_eer_error, 0);
}

TEST(CollisionOdds, AreToldForEachMapAndNotWhereNothingIsKnown) {
  std::vector<db::MapPoint> points = map_where([](double, double) { return 2; });
  std::vector<db::MapPoint> others = map_where([](double, double) { return 0; }, 0.5);
  std::vector<db::MapPoint> unknown = map_where([](double, double) { return 0; }, 0.25);
  for (db::MapPoint& p : unknown) p.results = 0;
  for (const auto* more : {&others, &unknown})
    points.insert(points.end(), more->begin(), more->end());
  const auto odds = collision_odds(points, {10});
  ASSERT_EQ(odds.size(), 2u);
  EXPECT_EQ(odds[1].q, 0.5);
  EXPECT_EQ(odds[1].p_eer, 0);
}

}  // namespace
}  // namespace eerie::surroundings
