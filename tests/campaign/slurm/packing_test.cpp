#include "campaign/slurm/packing.hpp"

#include <gmock/gmock.h>

namespace eerie::slurm {
namespace {
using testing::ElementsAre;
using testing::SizeIs;

std::vector<manager::Task> of_costs(const std::vector<double>& costs) {
  std::vector<manager::Task> tasks;
  for (const double cost : costs)
    tasks.push_back({static_cast<std::int64_t>(tasks.size()), {}, cost});
  return tasks;
}

std::vector<std::vector<std::int64_t>> jobs(const std::vector<std::vector<manager::Task>>& packs) {
  std::vector<std::vector<std::int64_t>> ids;
  for (const auto& pack : packs) {
    ids.emplace_back();
    for (const manager::Task& task : pack) ids.back().push_back(task.job);
  }
  return ids;
}

TEST(Packing, PutsShortJobsTogetherLongestFirst) {
  EXPECT_THAT(jobs(packed(of_costs({10, 60, 40, 30, 55, 5}), 100)),
              ElementsAre(ElementsAre(1, 2), ElementsAre(4, 3, 0, 5)));
}

TEST(Packing, KeepsEveryJobOnceAndEveryPackBelowItsSize) {
  std::vector<double> costs;
  for (int k = 0; k < 500; ++k) costs.push_back(1 + (k * 7919) % 97);
  const auto tasks = of_costs(costs);
  const auto packs = packed(tasks, 100);
  std::set<std::int64_t> seen;
  double total = 0;
  for (const auto& pack : packs) {
    double sum = 0;
    for (const manager::Task& task : pack) {
      sum += task.expected_core_seconds;
      EXPECT_TRUE(seen.insert(task.job).second);
    }
    EXPECT_LE(sum, 100);
    total += sum;
  }
  EXPECT_EQ(seen.size(), 500u);
  // Best fit, longest first, takes at most 11/9 of the least possible number and a little.
  EXPECT_LE(static_cast<double>(packs.size()), 11.0 / 9 * total / 100 + 4);
}

TEST(Packing, GivesAJobThatIsTooLongOrOfUnknownCostItsOwn) {
  EXPECT_THAT(jobs(packed(of_costs({500, 0, 10, 0, 20}), 100)),
              ElementsAre(ElementsAre(0), ElementsAre(4, 2), ElementsAre(1), ElementsAre(3)));
}

TEST(Packing, OfNothingOrWithoutRoomIsNone) {
  EXPECT_THAT(packed({}, 100), SizeIs(0));
  EXPECT_THAT(packed(of_costs({1e-9, 2, 3}), 0), SizeIs(3));
}

TEST(Packing, DoesNotPutThousandsOfTinyJobsIntoOne) {
  EXPECT_GE(packed(of_costs(std::vector<double>(1000, 1e-6)), 100).size(), 10u);
}

TEST(Packing, DoesNotDependOnTheOrderOfTheTasks) {
  auto tasks = of_costs({10, 10, 30, 30, 20, 50});
  const auto first = jobs(packed(tasks, 60));
  std::reverse(tasks.begin(), tasks.end());
  EXPECT_EQ(jobs(packed(tasks, 60)), first);
}

TEST(PackSize, FollowsTheProfileAndStaysWithinItsTimeLimit) {
  SlurmProfile profile;
  profile.minutes_per_array_task = 30;
  EXPECT_DOUBLE_EQ(pack_core_seconds(profile), 1800);
  profile.cpus_per_task = 4;
  EXPECT_DOUBLE_EQ(pack_core_seconds(profile), 4 * 1800);
  profile.time_limit = std::chrono::minutes(12);
  EXPECT_LT(pack_core_seconds(profile), 4 * 600);
  EXPECT_GT(pack_core_seconds(profile), 4 * 300);
}

}  // namespace
}  // namespace eerie::slurm
