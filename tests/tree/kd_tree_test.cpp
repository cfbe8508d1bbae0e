#include "solver/tree/kd_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/particles.hpp"
#include "tests/tree/clouds.hpp"

namespace eerie::tree {
namespace {

using test::cloud;
using test::cloud_names;

TEST(KdOrder, IsAPermutation) {
  for (const std::size_t n : {1u, 15u, 16u, 17u, 63u, 64u, 65u, 100u, 1000u, 1025u}) {
    std::vector<std::uint32_t> order = kd_order(cloud("clustered", n), test::ids(n));
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, test::ids(n));
  }
}

TEST(KdOrder, DoesNotDependOnTheOrderItStartsFrom) {
  for (const char* name : cloud_names) {
    const std::vector<Vec3> x = cloud(name, 777);
    const std::vector<std::uint32_t> id = test::ids(x.size()), order = kd_order(x, id);
    std::vector<std::uint32_t> shuffled = id;
    Random random(5, 0);
    for (std::size_t i = x.size() - 1; i > 0; --i)
      std::swap(shuffled[i],
                shuffled[static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1))]);
    ASSERT_NE(shuffled, id);
    std::vector<Vec3> moved;
    for (const std::uint32_t i : shuffled) moved.push_back(x[i]);
    // The ids travel with their positions; the ids found in order must be the same.
    std::vector<std::uint32_t> found;
    for (const std::uint32_t k : kd_order(moved, shuffled)) found.push_back(shuffled[k]);
    EXPECT_EQ(found, order) << name;
  }
}

TEST(KdOrder, EqualPositionsAreOrderedById) {
  // A coarse grid: whole planes of equal coordinates, and every point twice.
  std::vector<Vec3> x;
  for (int k = 0; k < 1000; ++k)
    x.push_back({double(k % 5), double(k / 5 % 5), double(k / 25 % 20)});
  const std::vector<std::uint32_t> id = test::ids(x.size()), order = kd_order(x, id);
  std::vector<Vec3> reversed(x.rbegin(), x.rend());
  std::vector<std::uint32_t> reversed_id(id.rbegin(), id.rend()), found;
  for (const std::uint32_t k : kd_order(reversed, reversed_id)) found.push_back(reversed_id[k]);
  EXPECT_EQ(found, order);
}

TEST(KdOrder, KeepsNeighboursTogether) {
  const std::vector<Vec3> x = test::glass_ball(4096);
  // 64 points at unit density fill a cube of side 4; boxes of buckets stay near that, where
  // buckets of an unsorted cloud are as wide as the ball (about 20).
  double mean = 0;
  for (std::size_t b = 0; b < bucket_count(x.size()); ++b) {
    Box box;
    for (std::size_t i = b * bucket_size; i < (b + 1) * bucket_size; ++i) box.include(x[i]);
    mean += norm(box.extent()) / static_cast<double>(bucket_count(x.size()));
  }
  EXPECT_LT(mean, 12);
}

TEST(KdTree, LeavesCoverEveryParticleOnceAndBucketsAreWholeNodes) {
  for (const std::size_t n : {1u, 16u, 17u, 64u, 65u, 100u, 1000u, 1025u, 6399u}) {
    const KdTree tree(n);
    std::vector<int> covered(n, 0);
    for (const KdTree::Node& node : tree.nodes) {
      if (node.size() > bucket_size) {
        EXPECT_EQ(node.begin % bucket_size, 0u);
      }
      if (!node.is_leaf()) {
        EXPECT_EQ(tree.nodes[node.left].begin, node.begin);
        EXPECT_EQ(tree.nodes[node.left].end, tree.nodes[node.right].begin);
        EXPECT_EQ(tree.nodes[node.right].end, node.end);
        continue;
      }
      EXPECT_LE(node.size(), KdTree::leaf_size);
      EXPECT_GT(node.size(), 0u);
      EXPECT_EQ(node.begin / bucket_size, (node.end - 1) / bucket_size);
      for (std::uint32_t i = node.begin; i < node.end; ++i) ++covered[i];
    }
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), static_cast<long>(n));
  }
}

TEST(KdTree, EveryBoxIsTheTightestAroundItsParticles) {
  for (const char* name : cloud_names) {
    const std::vector<Vec3> x = test::in_kd_order(cloud(name, 1000));
    const KdTree tree = test::fitted_tree(x);
    for (const KdTree::Node& node : tree.nodes) {
      Box box;
      for (std::uint32_t i = node.begin; i < node.end; ++i) box.include(x[i]);
      EXPECT_EQ(box.lo, node.box.lo);
      EXPECT_EQ(box.hi, node.box.hi);
    }
  }
}

}  // namespace
}  // namespace eerie::tree
