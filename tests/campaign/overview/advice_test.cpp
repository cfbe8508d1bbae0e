#include "campaign/overview/advice.hpp"

#include <gmock/gmock.h>

#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/sweeps/plan.hpp"

namespace eerie::overview {
namespace {
using nlohmann::json;

std::vector<Scene> scenes(const json& grid) {
  return sweeps::plan({{"name", "s"}, {"grid", grid}}, {}, "s.json").scenes;
}

const json speeds = {{"v_imp_cm_per_s", {10, 15, 20}}, {"theta_imp_deg", {15}}};

TEST(Advice, CostsWhatTheRunsOfASweepOfThatFidelityCost) {
  constexpr double speed = 2e6;
  const Advice found = advice(scenes(speeds), speed);
  EXPECT_EQ(found.impacts, 3u);
  ASSERT_EQ(found.choices.size(), std::size(sweeps::fidelities));
  for (const Choice& c : found.choices) {
    double steps = 0;
    const auto plan = sweeps::plan({{"name", "s"}, {"grid", speeds}},
                                   sweeps::overrides_of_fidelity(c.fidelity), "s.json");
    for (const db::NewJob& job : plan.jobs) steps += job.expected_particle_steps;
    EXPECT_NEAR(c.core_hours / (c.seeds * steps / speed / 3600), 1, 1e-9) << c.fidelity;
    EXPECT_EQ(c.particles_per_target, plan.jobs.front().particles_per_target);
  }
}

TEST(Advice, LeavesOutWhatHasTooFewParticlesForASmallImpactor) {
  json grid = speeds;
  grid["q"] = {1, 0.1};  // sketches would give it 40
  const Advice found = advice(scenes(grid), 1e6);
  ASSERT_EQ(found.choices.size(), std::size(sweeps::fidelities) - 1);
  EXPECT_EQ(found.choices.front().fidelity, "survey");
  EXPECT_GT(found.auto_least_core_hours, 0);
}

TEST(Advice, CountsImpactsAndNotTheirSeedsOrParticles) {
  json grid = speeds;
  grid["numerics.seed"] = {1, 2, 3, 4};
  grid["numerics.particles_per_target"] = {400, 1000};
  EXPECT_EQ(advice(scenes(grid), 1e6).impacts, 3u);
  EXPECT_NEAR(advice(scenes(grid), 1e6).choices[0].core_hours,
              advice(scenes(speeds), 1e6).choices[0].core_hours, 1e-12);
}

TEST(Advice, OfManyImpactsIsThatOfASampleOfThem) {
  const json grid = {{"v_imp_cm_per_s", {{"from", 10}, {"to", 39.5}, {"step", 0.5}}},
                     {"theta_imp_deg", {{"from", 1}, {"to", 40}, {"step", 1}}}};
  const Advice found = advice(scenes(grid), 1e6);
  EXPECT_EQ(found.impacts, 2400u);
  // Runs that end once settled are expected to take as long at any speed and angle.
  EXPECT_NEAR(found.choices[0].core_hours / advice(scenes(speeds), 1e6).choices[0].core_hours,
              2400 / 3.0, 1);
}

TEST(Advice, OfAutoLiesBetweenTwoSketchesAndAllThatItMayAskFor) {
  const Advice found = advice(scenes(speeds), 1e6);
  const double sketch = found.choices[0].core_hours / found.choices[0].seeds,
               fine = found.choices[3].core_hours / found.choices[3].seeds;
  EXPECT_NEAR(found.auto_least_core_hours / (2 * sketch), 1, 1e-12);
  EXPECT_GT(found.auto_most_core_hours, 8 * fine);
  EXPECT_LT(found.auto_most_core_hours, 10 * fine);
}

TEST(Advice, NamesTheFinestChoiceForANight) {
  const Advice found{3,
                     {{"sketch", 400, 1, 1, 0.2, 0.7},
                      {"survey", 1000, 2, 15, 0.1, 0.9},
                      {"standard", 5000, 4, 17, 0.05, 1},
                      {"paper", 50000, 1, 2, 0, 0}}};
  EXPECT_EQ(finest_within(found, 8, 2).value().fidelity, "survey");
  EXPECT_EQ(finest_within(found, 8, 4).value().fidelity, "standard");
  EXPECT_FALSE(finest_within(found, 0.1, 2));
}

}  // namespace
}  // namespace eerie::overview
