#include "analysis/remnants/clumps.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "solver/base/error.hpp"
#include "tests/analysis/remnants/bodies.hpp"

namespace eerie::remnants {
namespace {

using testing::ElementsAre;

std::vector<std::uint32_t> natural_ids(std::size_t n) {
  std::vector<std::uint32_t> id(n);
  std::iota(id.begin(), id.end(), 0u);
  return id;
}

/// Friends-of-friends in the dumbest way: all pairs, labels pulled down until none changes.
std::vector<std::size_t> labels_by_all_pairs(const std::vector<Vec3>& x, double linking_length) {
  std::vector<std::size_t> label(x.size());
  std::iota(label.begin(), label.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j)
        if (label[j] < label[i] && norm2(x[i] - x[j]) <= linking_length * linking_length)
          label[i] = label[j], changed = true;
  }
  return label;
}

/// Particles strewn so that about half are in clumps, some of them far from the origin.
std::vector<Vec3> strewn(std::size_t n, std::uint64_t seed) {
  Random random(seed, 3);
  std::vector<Vec3> x;
  for (std::size_t i = 0; i < n; ++i) {
    const double far = i % 50 == 0 ? 1e5 : 1.0;
    x.push_back(far * Vec3{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)});
  }
  return x;
}

TEST(FriendsOfFriends, AgreesWithAllPairs) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<Vec3> x = strewn(1000, seed);
    const double linking_length = 0.3 + 0.15 * static_cast<double>(seed);
    const std::vector<std::size_t> wanted = labels_by_all_pairs(x, linking_length);
    std::vector<std::size_t> found(x.size());
    const auto clumps = friends_of_friends(x, natural_ids(x.size()), linking_length);
    EXPECT_GT(clumps.size(), 10u) << "the sample must have clumps to tell apart";
    EXPECT_GT(clumps.front().size(), 2u);
    for (const Clump& clump : clumps)
      for (const std::uint32_t i : clump) found[i] = clump.front();
    EXPECT_EQ(found, wanted) << "seed " << seed;
  }
}

TEST(FriendsOfFriends, LinkingLengthItselfStillLinks) {
  const std::vector<Vec3> x = {{0, 0, 0}, {1, 0, 0}, {2.0000001, 0, 0}};
  EXPECT_THAT(friends_of_friends(x, natural_ids(3), 1.0),
              ElementsAre(ElementsAre(0, 1), ElementsAre(2)));
}

TEST(FriendsOfFriends, ChainAcrossManyCellsIsOneClump) {
  std::vector<Vec3> x;
  for (int i = 0; i < 1000; ++i) x.push_back({-500 + 0.99 * i, 0.1 * i, -0.05 * i});
  EXPECT_EQ(friends_of_friends(x, natural_ids(x.size()), 1.0).size(), 1u);
}

TEST(FriendsOfFriends, ClumpsAreSortedBySizeThenSmallestId) {
  // Three pairs and a triple, with ids that run against memory order.
  const std::vector<Vec3> x = {{0, 0, 0},    {0.5, 0, 0}, {10, 0, 0},   {10.5, 0, 0}, {20, 0, 0},
                               {20.5, 0, 0}, {30, 0, 0},  {30.5, 0, 0}, {31, 0, 0}};
  const std::vector<std::uint32_t> id = {8, 7, 6, 0, 4, 3, 2, 1, 5};
  EXPECT_THAT(friends_of_friends(x, id, 1.0), ElementsAre(ElementsAre(7, 6, 8), ElementsAre(3, 2),
                                                          ElementsAre(5, 4), ElementsAre(1, 0)));
}

TEST(FriendsOfFriends, MemoryOrderDoesNotMatter) {
  particles::State state = test::empty_state();
  const std::vector<Vec3> x = strewn(2000, 9);
  test::add(state, x, x, particles::Body::target);
  const particles::State other = test::shuffled(state, 4);
  const auto ids = [](const particles::State& s) {
    std::vector<std::vector<std::uint32_t>> all;
    for (const Clump& clump : friends_of_friends(s.x, s.id, 0.6)) {
      all.emplace_back();
      for (const std::uint32_t i : clump) all.back().push_back(s.id[i]);
    }
    return all;
  };
  EXPECT_EQ(ids(state), ids(other));
}

TEST(FriendsOfFriends, NothingHasNoClumps) { EXPECT_TRUE(friends_of_friends({}, {}, 1.0).empty()); }

TEST(FriendsOfFriends, ParticleBeyondAllGridsIsAnError) {
  const std::vector<Vec3> x = {{0, 0, 0}, {1e300, 0, 0}};
  EXPECT_THROW(friends_of_friends(x, natural_ids(2), 1.0), NumericalError);
}

}  // namespace
}  // namespace eerie::remnants
