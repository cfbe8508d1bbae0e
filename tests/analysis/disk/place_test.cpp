#include "analysis/disk/place.hpp"

#include <gtest/gtest.h>

namespace eerie::disk {
namespace {

TEST(Place, IsAnsweredByBothLawsForThePapersBodyAndByOneForOthers) {
  const Nebula n = hayashi_nebula(5 * astronomical_unit);
  EXPECT_EQ(places_at(n, {}).size(), 2u);
  EXPECT_EQ(places_at(n, {}).front().law, DragLaw::published);
  PlaceQuestion smaller;
  smaller.body.radius = 50;
  ASSERT_EQ(places_at(n, smaller).size(), 1u);
  EXPECT_EQ(places_at(n, smaller).front().law, DragLaw::weidenschilling);
}

TEST(Place, LimitsAreWhereItsSpeedsReachThem) {
  const Nebula n = hayashi_nebula(12 * astronomical_unit);
  PlaceQuestion question;
  for (const Place& found : places_at(n, question)) {
    PlaceQuestion at_limit = question;
    at_limit.alpha = found.alpha_fast;
    at_limit.stirrer_radius = found.stirrer_radius_slow;
    for (const Place& place : places_at(n, at_limit)) {
      if (place.law != found.law) continue;
      EXPECT_NEAR(place.turbulent_speed, 0.40, 1e-9);
      EXPECT_NEAR(place.stirred_speed, 0.15, 1e-9);
    }
  }
}

}  // namespace
}  // namespace eerie::disk
