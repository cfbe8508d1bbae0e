#include "campaign/manager/campaign_run.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace eerie::manager {
namespace {

struct Planned {
  Scene scene;
};

TEST(Affordable, SpendsNoMoreThanItsBudget) {
  std::vector<Planned> runs(5, Planned{parse_scene(nlohmann::json::object())});
  for (std::size_t k = 0; k < runs.size(); ++k)
    runs[k].scene.numerics.particles_per_target = 300 * (1 + static_cast<std::int64_t>(k));
  const double first_two = sweeps::expected_particle_steps(runs[0].scene) +
                           sweeps::expected_particle_steps(runs[1].scene);
  constexpr double rate = 1e6;
  const db::Speed speed{2, 2 * rate, 0}, slower_than_expected{2, 2 * rate, 0.5};
  EXPECT_EQ(affordable(runs, 1.001 * first_two / rate / 3600, speed).size(), 2u);
  EXPECT_EQ(affordable(runs, 0.999 * first_two / rate / 3600, speed).size(), 1u);
  EXPECT_EQ(affordable(runs, 1e6, speed).size(), runs.size());
  EXPECT_EQ(affordable(runs, 1.999 * first_two / rate / 3600, slower_than_expected).size(), 1u);
  EXPECT_EQ(affordable(runs, 2.001 * first_two / rate / 3600, slower_than_expected).size(), 2u);
}

}  // namespace
}  // namespace eerie::manager
