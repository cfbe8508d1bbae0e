#include "analysis/disk/contours.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

namespace eerie::disk {
namespace {
using testing::HasSubstr;
using testing::StartsWith;

constexpr double au = astronomical_unit;

TEST(ContourDistances, RiseFromEndToEndWithAPairAtEveryStepBetween) {
  const std::vector<double> r = contour_distances(au, 100 * au);
  EXPECT_EQ(r.front(), au);
  EXPECT_EQ(r.back(), 100 * au);
  EXPECT_TRUE(std::ranges::is_sorted(r, std::less_equal<>()));
  for (const double step : {1.6, 2.7, 19.0}) {
    const auto at = std::ranges::lower_bound(r, step * au * (1 - 1e-8));
    EXPECT_LT(*at, step * au) << step;
    EXPECT_LT(*(at + 1) / *at, 1 + 1e-8) << step;
  }
  // 30 to 90 AU has no step; 1 to 3 AU, as wide, has two.
  EXPECT_EQ(contour_distances(au, 3 * au).size(), contour_distances(30 * au, 90 * au).size() + 4);
}

TEST(Contours, LieWhereBodiesMeetWithTheirSpeed) {
  const std::vector<double> r = contour_distances(0.5 * au, 50 * au);
  const Stirrers stirrers{0.02, 2700};
  for (const DragLaw law : {DragLaw::published, DragLaw::weidenschilling}) {
    const Contours alpha = alpha_contours(law, {}, r);
    const Contours radius = stirrer_contours(law, {}, stirrers, r);
    ASSERT_EQ(alpha.y.size(), contour_speeds.size());
    for (std::size_t i = 0; i < r.size(); i += 17)
      for (const double speed : contour_speeds) {
        const Nebula n = hayashi_nebula(r[i]);
        const Drag drag = drag_of(law, n, {});
        EXPECT_NEAR(turbulent_speed(n, drag, alpha.of(speed)[i]), speed, 1e-9 * speed);
        EXPECT_NEAR(stirred_speed(n, drag, stirrers, radius.of(speed)[i]), speed, 1e-9 * speed);
      }
  }
}

TEST(Contours, OfOtherSpeedsAreNotThere) {
  const Contours c = alpha_contours(DragLaw::published, {}, {au});
  EXPECT_EQ(c.of(0.15).size(), 1u);
  EXPECT_THROW(c.of(0.16), std::out_of_range);
}

TEST(ContoursCsv, HasALineForEachLawAndDistanceAndUnitsInItsHeader) {
  const std::vector<double> r = {au, 25 * au};
  const std::string csv = contours_csv({stirrer_contours(DragLaw::published, {}, {}, r),
                                        stirrer_contours(DragLaw::weidenschilling, {}, {}, r)},
                                       "stirrer_radius_km", 1000);
  EXPECT_THAT(csv,
              StartsWith("drag,r_au,regime,t_s_s,t_s_omega_k,stirrer_radius_km_at_2_cm_per_s,"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
  EXPECT_THAT(csv, HasSubstr("\npublished,25,Epstein,"));
  EXPECT_THAT(csv, HasSubstr(",2750,")) << "22 times 25^(3/2)";
  EXPECT_THAT(csv, HasSubstr("\nweidenschilling,1,Newton,"));
}

}  // namespace
}  // namespace eerie::disk
