#include "campaign/facts/finding.hpp"

#include <gmock/gmock.h>

namespace eerie::facts {
namespace {

using testing::ElementsAre;

db::ResultRow row(double phi_d, double v, double theta, int n_eer) {
  db::ResultRow r;
  r.q = 1, r.phi_d_deg = phi_d, r.v_imp_cm_per_s = v, r.theta_imp_deg = theta;
  r.result.n_eer = n_eer;
  return r;
}

TEST(Finding, SaysHowManyImpactsMakeAnElongatedRemnantAndWhere) {
  // 20 sin 15 deg = 5.18, 18 sin 15 deg = 4.66 cm/s. A second seed of an impact is no second
  // impact.
  EXPECT_THAT(
      finding({row(40, 18, 15, 1), row(40, 20, 15, 0), row(40, 20, 15, 1), row(40, 15, 10, 0)}),
      ElementsAre("2 of 3 impacts make an extremely elongated remnant (b/a < 0.3), at v sin(theta) "
                  "= 4.7 to 5.2 cm/s; the paper has them along 5.1 cm/s"));
}

TEST(Finding, SaysThatNoneDoesAndIsSilentAboutAPaperThatIs) {
  EXPECT_THAT(finding({row(45, 18, 15, 0)}),
              ElementsAre("none of 1 impacts makes an extremely elongated remnant (b/a < 0.3)"));
  EXPECT_TRUE(finding({}).empty());
}

TEST(Finding, HasOneSentencePerMassRatioAndFriction) {
  EXPECT_THAT(
      finding({row(40, 15, 10, 0), row(50, 20, 20, 1)}),
      ElementsAre("q 1, phi_d 40 deg: none of 1 impacts makes an extremely elongated remnant (b/a "
                  "< 0.3); the paper has them along 5.1 cm/s",
                  "q 1, phi_d 50 deg: 1 of 1 impacts make an extremely elongated remnant (b/a < "
                  "0.3), at v sin(theta) = 6.8 cm/s; the paper has them along 7.4 cm/s"));
}

TEST(Finding, KeepsImpactsOfOtherSettingsApart) {
  db::ResultRow other = row(45, 18, 15, 0);
  other.settings = 2;
  EXPECT_THAT(finding({row(45, 18, 15, 1), other}),
              ElementsAre(testing::StartsWith("q 1, phi_d 45 deg, settings 0: 1 of 1"),
                          testing::StartsWith("q 1, phi_d 45 deg, settings 2: none of 1")));
}

}  // namespace
}  // namespace eerie::facts
