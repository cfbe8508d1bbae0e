#include "campaign/text/closest_names.hpp"

#include <gmock/gmock.h>

namespace eerie::text {
namespace {
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

const std::vector<std::string> fields = {"impact.q",
                                         "impact.v_imp_cm_per_s",
                                         "impact.theta_imp_deg",
                                         "material.drucker_prager.phi_d_deg",
                                         "numerics.particles_per_target",
                                         "numerics.seed",
                                         "end.time_s"};

TEST(ClosestNames, KnowFieldsByWhatPeopleCallThem) {
  EXPECT_THAT(closest_names("numerics.particles", fields),
              StartsWith("numerics.particles_per_target"));
  EXPECT_THAT(closest_names("velocity", fields), StartsWith("impact.v_imp_cm_per_s"));
  EXPECT_THAT(closest_names("impact.Velocity", fields), StartsWith("impact.v_imp_cm_per_s"));
  EXPECT_THAT(closest_names("friction", fields), StartsWith("material.drucker_prager.phi_d_deg"));
  EXPECT_THAT(closest_names("angle", fields), StartsWith("impact.theta_imp_deg"));
  EXPECT_THAT(closest_names("mass_ratio", fields), StartsWith("impact.q"));
  EXPECT_THAT(closest_names("numerics.resolution", fields),
              StartsWith("numerics.particles_per_target"));
}

TEST(ClosestNames, StillKnowThemBySpelling) {
  EXPECT_THAT(closest_names("numerics.sead", fields), StartsWith("numerics.seed"));
  EXPECT_THAT(closest_names("vimp", fields), StartsWith("impact.v_imp_cm_per_s"));
}

TEST(LikelyNames, AreThoseThatAreMeantAloneOrThoseNearby) {
  EXPECT_THAT(likely_names("velocity", fields), ElementsAre("impact.v_imp_cm_per_s"));
  EXPECT_THAT(likely_names("--database", {"--db", "--set"}), ElementsAre("--db"));
  EXPECT_THAT(likely_names("quary", {"query", "map", "run"}), ElementsAre("query"));
  EXPECT_THAT(likely_names("plot", {"query", "map", "run"}), ElementsAre("map"));
  EXPECT_THAT(likely_names("--worker", {"--workers", "--db"}), ElementsAre("--workers"));
}

TEST(LikelyNames, AreNoneWhereNothingIsNear) {
  EXPECT_THAT(likely_names("banana", fields), IsEmpty());
  EXPECT_THAT(likely_names("fly", {"query", "map", "run"}), IsEmpty());
  EXPECT_THAT(likely_names("", fields), IsEmpty());
}

}  // namespace
}  // namespace eerie::text
