#include "campaign/sweeps/job.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace eerie::sweeps {
namespace {

Scene scene_with(const nlohmann::json& fields) { return parse_scene(fields); }

TEST(Job, KnowsTheMutualEscapeSpeedsOfThePapersBodies) {
  for (const auto& [q, cm_per_s] : {std::pair{1.0, 6.14}, {0.5, 5.62}, {0.25, 5.38}})
    EXPECT_NEAR(100 * mutual_escape_speed(scene_with({{"impact", {{"q", q}}}})), cm_per_s, 0.006)
        << q;
}

TEST(Job, ExpectsTwiceTheWorkForTwiceTheTime) {
  const double once = expected_particle_steps(scene_with({{"end", {{"time_s", 1e4}}}}));
  EXPECT_NEAR(expected_particle_steps(scene_with({{"end", {{"time_s", 2e4}}}})) / once, 2, 1e-3);
}

TEST(Job, ExpectsRunsThatMaySettleToEndAsOthersDid) {
  nlohmann::json fields = {{"end", {{"time_s", 6e4}}}};
  EXPECT_EQ(expected_end_s(scene_with(fields)), 6e4);
  fields["end"]["settled"]["window_s"] = 4000;
  EXPECT_EQ(expected_end_s(scene_with(fields)), 3e4);
  fields["numerics"]["rigid_flight"] = true;
  EXPECT_EQ(expected_end_s(scene_with(fields)), 5e4);
  fields["end"]["time_s"] = 1e4;
  EXPECT_EQ(expected_end_s(scene_with(fields)), 1e4);
}

TEST(Job, ExpectsTheWorkThatTheCourantConditionGives) {
  // N = 8000 makes the spacing of a 50 m body (4 pi / 3 / 8000)^(1/3) 50 m = 4.03 m, h = 4.836 m;
  // c_l = sqrt((26700 + 4/3 22700) / 2700) = 4.593 m/s; dt = 0.7 h / c_l = 0.737 s.
  const Scene scene = scene_with(
      {{"numerics", {{"particles_per_target", 8000}, {"cfl", 0.7}}}, {"end", {{"time_s", 1000}}}});
  EXPECT_NEAR(expected_particle_steps(scene), 16000 * 1357, 16000 * 4);
}

TEST(Job, HasTheColumnsOfItsScene) {
  const db::NewJob job =
      new_job(scene_with({{"impact", {{"q", 0.5}, {"v_imp_cm_per_s", 22}, {"theta_imp_deg", 7.5}}},
                          {"numerics", {{"seed", 9}}}}));
  EXPECT_EQ(job.q, 0.5);
  EXPECT_EQ(job.v_imp_cm_per_s, 22);
  EXPECT_EQ(job.theta_imp_deg, 7.5);
  EXPECT_EQ(job.seed, 9);
  EXPECT_NEAR(job.v_over_v_esc, 22 / 5.62, 0.01);
  EXPECT_EQ(job.hash, scene_hash(parse_scene(nlohmann::json::parse(job.scene))));
}

TEST(Job, OfScenesInOrderComesAfterThoseBeforeIt) {
  const Scene cheap = scene_with({{"numerics", {{"particles_per_target", 300}}}});
  const Scene dear = scene_with({{"numerics", {{"particles_per_target", 5000}}}});
  const std::vector<db::NewJob> jobs = jobs_in_order({cheap, dear, cheap});
  ASSERT_EQ(jobs.size(), 2u);
  EXPECT_EQ(jobs[0].hash, scene_hash(cheap));
  EXPECT_GT(jobs[0].priority, jobs[1].priority);
}

}  // namespace
}  // namespace eerie::sweeps
