#include "solver/tree/neighbour_list.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <utility>

#include "solver/base/error.hpp"
#include "tests/support/particles.hpp"
#include "tests/tree/clouds.hpp"

namespace eerie::tree {
namespace {

using test::cloud;
using test::cloud_names;

constexpr double support = 2.4;

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // sorted

/// Ordered pairs (i, j), i != j, held by the lists; every entry is checked on the way.
Pairs listed(const NeighbourList& lists, std::size_t n) {
  Pairs pairs;
  for (std::size_t b = 0; b < lists.buckets(); ++b) {
    const BucketList& list = lists[b];
    for (std::size_t k = 0; k < bucket_size; ++k) {
      EXPECT_EQ((list.begin[k + 1] - list.begin[k]) % NeighbourList::padding, 0u);
      for (std::uint32_t l = list.begin[k]; l < list.begin[k + 1]; ++l) {
        const std::size_t i = b * bucket_size + k;
        EXPECT_LT(i, n) << "a list of a particle that is not there";
        EXPECT_LE(list.index[l], list.rows.size());
        if (list.index[l] == list.rows.size()) continue;  // the dummy
        pairs.emplace_back(static_cast<std::uint32_t>(i), list.rows[list.index[l]]);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end()) << "a pair listed twice";
  return pairs;
}

Pairs closer_than(const std::vector<Vec3>& x, double radius) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < x.size(); ++i)
    for (std::uint32_t j = 0; j < x.size(); ++j)
      if (i != j && norm2(x[i] - x[j]) < radius * radius) pairs.emplace_back(i, j);
  return pairs;
}

bool includes(const Pairs& all, const Pairs& part) {
  return std::includes(all.begin(), all.end(), part.begin(), part.end());
}

NeighbourList built(const std::vector<Vec3>& x, double skin) {
  NeighbourList lists(support, skin);
  lists.build(test::fitted_tree(x), x);
  return lists;
}

/// Distances are compared in single precision relative to the bucket: in a bucket of scattered
/// ejecta, up to 2e4 across, they are off by 1e-3 at most.
double rounding(const std::string& name) { return name == "far-flung" ? 2e-3 : 3e-5 * support; }

TEST(NeighbourList, HoldsEveryPairWithinReachAndNoOther) {
  for (const char* name : cloud_names)
    for (const std::size_t n : {1u, 2u, 63u, 64u, 65u, 700u, 1000u})
      for (const double skin : {0.0, 0.24}) {
        SCOPED_TRACE(testing::Message() << name << ", " << n << " particles, skin " << skin);
        const std::vector<Vec3> x = test::in_kd_order(cloud(name, n));
        const Pairs found = listed(built(x, skin), n);
        EXPECT_TRUE(includes(found, closer_than(x, support + skin - rounding(name))));
        EXPECT_TRUE(includes(closer_than(x, support + skin + rounding(name)), found));
      }
}

TEST(NeighbourList, ParticlesWithFewNeighboursAreLooseWithASkinAndWithout) {
  for (const double skin : {0.0, 0.24}) {
    std::size_t loose = 0;
    for (const char* name : cloud_names) {
      const std::vector<Vec3> x = test::in_kd_order(cloud(name, 1000));
      const NeighbourList lists = built(x, skin);
      std::vector<std::size_t> neighbours(x.size());
      for (const auto& [i, j] : listed(lists, x.size())) ++neighbours[i];
      for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_EQ(lists.is_bulk(i), neighbours[i] > 8) << name << ", skin " << skin;
        loose += !lists.is_bulk(i);
      }
    }
    EXPECT_GT(loose, 100) << "guards the test";
  }
}

TEST(NeighbourList, CloudsHaveNeighboursAndStrangers) {
  // Guards the test above against clouds in which all or no pairs are near.
  for (const char* name : cloud_names) {
    const std::size_t n = 1000, pairs = closer_than(cloud(name, n), support).size();
    EXPECT_GT(pairs, 5 * n) << name;
    EXPECT_LT(pairs, n * n / 5) << name;
  }
}

TEST(NeighbourList, IsSymmetric) {
  for (const char* name : {"even", "clustered", "sheared"}) {
    const std::vector<Vec3> x = test::in_kd_order(cloud(name, 1000));
    const Pairs found = listed(built(x, 0.24), x.size());
    std::size_t one_sided = 0;
    for (const auto& [i, j] : found)
      one_sided += !std::binary_search(found.begin(), found.end(), std::pair{j, i});
    // Only pairs within rounding of the radius may be seen from one side alone.
    EXPECT_LE(one_sided, found.size() / 1000) << name;
  }
}

/// Random moves of length `step` for all particles.
std::vector<Vec3> moved(std::vector<Vec3> x, double step, std::uint64_t seed) {
  Random random(seed, 0);
  for (Vec3& p : x) p += step * random.direction();
  return x;
}

TEST(NeighbourList, SkinCoversParticlesThatMovedLessThanHalfOfIt) {
  constexpr double skin = 0.24;
  for (const char* name : cloud_names) {
    const std::vector<Vec3> x = test::in_kd_order(cloud(name, 700));
    const NeighbourList lists = built(x, skin);
    const Pairs found = listed(lists, x.size());
    EXPECT_FALSE(lists.used_up(x));
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const std::vector<Vec3> now = moved(x, 0.45 * skin, seed);
      EXPECT_TRUE(includes(found, closer_than(now, support - rounding(name)))) << name;
    }
  }
}

/// Ways in which the particles of an impact leave the places where lists were built.
struct Motion {
  const char* name;
  Vec3 drift, spin;  ///< of all, rigidly
  double stretch;    ///< along x, relative
  double jitter;     ///< of each by itself
};
constexpr Motion motions[] = {{"at random", {}, {}, 0, 1},
                              {"flying", {30, -10, 5}, {}, 0, 0.1},
                              {"spinning", {}, {0.1, -0.2, 0.3}, 0, 0.1},
                              {"flying and spinning", {10, 0, 0}, {0, 0, 0.3}, 0, 0.05},
                              {"collapsing", {}, {}, -0.5, 0.1},
                              {"torn apart", {3, 0, 0}, {0, 0.2, 0}, 0.5, 0.1}};

TEST(NeighbourList, MissesNoPairUntilItSaysThatItIsUsedUp) {
  constexpr double skin = 0.24;
  constexpr std::size_t n = 500;
  for (const char* name : cloud_names) {
    const std::vector<Vec3> x = test::in_kd_order(cloud(name, n));
    const NeighbourList lists = built(x, skin);
    const Pairs found = listed(lists, n);
    for (const Motion& motion : motions) {
      Random random(9, 0);
      std::vector<Vec3> v;
      for (const Vec3& p : x)
        v.push_back(motion.drift + cross(motion.spin, p) + Vec3{motion.stretch * p.x, 0, 0} +
                    motion.jitter * random.direction());
      int steps = 0;
      for (double time = 0;; time += 0.01, ++steps) {
        std::vector<Vec3> now = x;
        for (std::size_t i = 0; i < n; ++i) now[i] += time * v[i];
        if (lists.used_up(now)) break;
        ASSERT_TRUE(includes(found, closer_than(now, support - rounding(name))))
            << name << ", " << motion.name << " at " << time;
        ASSERT_LT(steps, 1000) << name << ", " << motion.name << ": never used up";
      }
    }
  }
}

TEST(NeighbourList, AWholeBodyMayUseAlmostHalfTheSkin) {
  constexpr double skin = 0.24;
  const std::vector<Vec3> x = test::in_kd_order(cloud("even", 700));
  const NeighbourList lists = built(x, skin);
  // Not quite half: motion is judged relative to the mean, itself a little off zero.
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    EXPECT_FALSE(lists.used_up(moved(x, 0.45 * skin, seed)));
}

TEST(NeighbourList, ABodyThatFliesAndTurnsNeedsNoNewLists) {
  const std::vector<Vec3> x = test::in_kd_order(cloud("even", 700));
  const NeighbourList lists = built(x, 0.24);
  std::vector<Vec3> now = x;
  // Far beyond the skin, at the surface by 0.5: but no pair has come closer.
  for (Vec3& p : now) p += Vec3{100, -50, 20} + cross({0.03, 0.05, -0.07}, p);
  EXPECT_FALSE(lists.used_up(now));
  EXPECT_TRUE(includes(listed(lists, x.size()), closer_than(now, support)));
}

TEST(NeighbourList, SaysSoWhenTheSkinIsUsedUp) {
  constexpr double skin = 0.24;
  const std::vector<Vec3> x = test::in_kd_order(cloud("even", 700));
  const NeighbourList lists = built(x, skin);
  std::vector<Vec3> now = x;
  now[123] += {0, 0.51 * skin, 0};  // one particle alone
  EXPECT_TRUE(lists.used_up(now));
  EXPECT_TRUE(built(x, 0).used_up(x));  // no skin: never trusted
}

TEST(NeighbourList, MissesPairsOnlyAfterItSaidSo) {
  // The lists are not all pairs: after long moves some near pairs are missing, and used_up() told.
  const std::vector<Vec3> x = test::in_kd_order(cloud("even", 700));
  const NeighbourList lists = built(x, 0.24);
  const std::vector<Vec3> now = moved(x, 1.0, 1);
  EXPECT_TRUE(lists.used_up(now));
  EXPECT_FALSE(includes(listed(lists, x.size()), closer_than(now, support)));
}

TEST(NeighbourList, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Vec3> x = test::in_kd_order(cloud("clustered", 1000));
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const NeighbourList one = built(x, 0.24);
  omp_set_num_threads(5);
  const NeighbourList five = built(x, 0.24);
  omp_set_num_threads(threads);
  for (std::size_t b = 0; b < one.buckets(); ++b) {
    EXPECT_EQ(one[b].rows, five[b].rows);
    EXPECT_EQ(one[b].index, five[b].index);
    EXPECT_EQ(one[b].begin, five[b].begin);
  }
}

TEST(NeighbourList, ACollapseIsAnErrorAndNotAnOverflow) {
  // 70,000 particles in one place do not fit 16-bit places.
  const std::vector<Vec3> x(70000, Vec3{1, 2, 3});
  NeighbourList lists(support, 0.24);
  const KdTree tree = test::fitted_tree(x);
  try {
    lists.build(tree, x);
    FAIL() << "built";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.kind, "collapse");
  }
}

}  // namespace
}  // namespace eerie::tree
