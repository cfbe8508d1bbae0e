#include "campaign/maps/impact_runs.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/support/impact_database.hpp"

namespace eerie::maps {
namespace {
using nlohmann::json;
using test::add_impact;
using test::survey_scene;
using testing::HasSubstr;

class ImpactRunsOf : public testing::Test {
 protected:
  ImpactRuns all() { return impact_runs(connection, {}); }
  test::TemporaryFolder folder;
  db::Connection connection{folder / "a.sqlite", db::Access::write};
};

TEST_F(ImpactRunsOf, AResultHaveItsPointItsSettingsAndItsRemnants) {
  add_impact(connection, survey_scene(0.5, 50, 25, 20, 3), 0.27);
  const ImpactRuns found = all();
  ASSERT_EQ(found.runs.size(), 1u);
  const paper::ImpactRun& run = found.runs[0];
  EXPECT_EQ(run.q, 0.5);
  EXPECT_EQ(run.phi_d_deg, 50);
  EXPECT_EQ(run.v_imp_cm_per_s, 25);
  EXPECT_EQ(run.theta_imp_deg, 20);
  EXPECT_EQ(run.seed, 3);
  EXPECT_EQ(run.settings.particles_per_target, 1000);
  EXPECT_EQ(run.settings.fidelity, "survey");
  EXPECT_EQ(run.stiffness, 1);
  EXPECT_EQ(run.b_over_a(), 0.27);
  EXPECT_TRUE(run.remnants.at(0).eer);
  EXPECT_EQ(remark(found), "");
}

TEST_F(ImpactRunsOf, OtherBodiesAreLeftOutAndCounted) {
  const std::pair<const char*, double> others[] = {
      {"/target/radius_m", 100},
      {"/material/drucker_prager/cohesion_Pa", 5},
      {"/material/tillotson/A_Pa", 2.67e5},
      {"/impactor/spin/period_h", 6},
      {"/impactor/material/phi_d_deg", 20},
  };
  for (const auto& [field, value] : others) {
    json scene = survey_scene(1, 40, 20, 15, 1);
    scene[json::json_pointer(field)] = value;
    add_impact(connection, scene, 0.2);
  }
  const ImpactRuns found = all();
  EXPECT_TRUE(found.runs.empty());
  EXPECT_EQ(found.other_bodies, 5u);
  EXPECT_THAT(remark(found), HasSubstr("5 are of other bodies than the paper's and left out"));
}

TEST_F(ImpactRunsOf, StifferBodiesAreKnownAsSuchAndInNoGroup) {
  json stiff = survey_scene(1, 40, 20, 15, 1);
  stiff["material"]["tillotson"] = {{"A_Pa", 2.67e5}, {"B_Pa", 2.67e5}};
  add_impact(connection, stiff, 0.25);
  add_impact(connection, survey_scene(1, 40, 20, 15, 1), 0.25);
  add_impact(connection, survey_scene(1, 50, 20, 15, 1), 0.25);
  const ImpactRuns found = all();
  EXPECT_EQ(found.runs.size(), 3u);
  EXPECT_NEAR(found.runs[0].stiffness + found.runs[1].stiffness, 11, 1e-9);
  const std::vector<ComparableRuns> groups = groups_of(found.runs);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].phi_d_deg, 40);
  EXPECT_EQ(groups[0].runs.size(), 1u);
}

TEST_F(ImpactRunsOf, RunsOfOtherSettingsAreOtherGroups) {
  json dual = survey_scene(1, 40, 20, 15, 1);
  dual["numerics"]["scheme"] = "dual";
  add_impact(connection, dual, 0.25);
  add_impact(connection, survey_scene(1, 40, 20, 15, 1), 0.25);
  const std::vector<ComparableRuns> groups = groups_of(all().runs);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].settings.name, "dual");
  EXPECT_EQ(groups[1].settings.name, "survey");
}

TEST_F(ImpactRunsOf, RunsOfTheSameSchemeThatDifferInAnyOtherSettingAreOtherGroups) {
  json sticky = survey_scene(1, 40, 20, 15, 1), plain = sticky;
  sticky["numerics"]["cfl"] = 0.5, plain["numerics"]["cfl"] = 0.6;
  add_impact(connection, sticky, 0.25);
  add_impact(connection, plain, 0.35);
  plain["numerics"]["seed"] = 2;
  add_impact(connection, plain, 0.35);
  const std::vector<ComparableRuns> groups = groups_of(all().runs);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].settings.name, groups[1].settings.name);
  EXPECT_EQ(groups[0].runs.size() + 2 * groups[1].runs.size(), 5u);
}

TEST_F(ImpactRunsOf, StifferBodiesHaveTheSettingsOfThePapersToBeComparedWithThem) {
  json stiff = survey_scene(1, 40, 20, 15, 1);
  stiff["material"]["tillotson"] = {{"A_Pa", 2.67e5}, {"B_Pa", 2.67e5}};
  add_impact(connection, stiff, 0.25);
  add_impact(connection, survey_scene(1, 40, 20, 15, 1), 0.25);
  const ImpactRuns found = all();
  EXPECT_EQ(found.runs.at(0).settings, found.runs.at(1).settings);
  db::ResultFilter filter;
  filter.settings = found.runs[0].settings.id;
  const ImpactRuns same = impact_runs(connection, filter);
  ASSERT_EQ(same.runs.size(), 1u);
  EXPECT_EQ(same.runs[0].stiffness, 1);
}

TEST_F(ImpactRunsOf, UnsettledResultsCountAndAreTold) {
  add_impact(connection, survey_scene(1, 40, 20, 15, 1), 0.5, false);
  const ImpactRuns found = all();
  ASSERT_EQ(found.runs.size(), 1u);
  EXPECT_FALSE(found.runs[0].settled);
  EXPECT_THAT(remark(found), HasSubstr("1 results are not settled"));
}

}  // namespace
}  // namespace eerie::maps
