#include "analysis/remnants/binding.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie::remnants {
namespace {

using testing::ElementsAre;

std::vector<std::vector<std::size_t>> members(const std::vector<BoundGroup>& groups) {
  std::vector<std::vector<std::size_t>> all;
  for (const BoundGroup& group : groups) all.push_back(group.members);
  return all;
}

/// Escape speed of two masses at a distance.
double v_esc(double m1, double m2, double r) { return std::sqrt(2 * newton_G * (m1 + m2) / r); }

TEST(BoundGroups, TwoBodiesPartAtTheirEscapeSpeed) {
  const double m1 = 1e9, m2 = 7e8, r = 400;
  for (const double direction : {-1.0, 1.0}) {
    const auto groups = [&](double speed) {
      const std::vector<PointMass> clumps = {{m1, {}, {1, 1, 1}},
                                             {m2, {r, 0, 0}, {1 + direction * speed, 1, 1}}};
      return members(bound_groups(clumps, 2));
    };
    EXPECT_THAT(groups(0.999 * v_esc(m1, m2, r)), ElementsAre(ElementsAre(0, 1)));
    EXPECT_THAT(groups(1.001 * v_esc(m1, m2, r)), ElementsAre(ElementsAre(0), ElementsAre(1)));
  }
}

TEST(BoundGroups, DebrisGoesToTheRemnantThatHoldsIt) {
  // Two remnants fly apart; a moonlet circles each. Seen from the heavier one, the moonlet of
  // the other flies away as well.
  const double m1 = 1e9, m2 = 8e8, m = 1e6, fast = 3 * v_esc(m1, m2, 1000);
  const std::vector<PointMass> clumps = {{m1, {}, {}},
                                         {m2, {1000, 0, 0}, {fast, 0, 0}},
                                         {m, {1150, 0, 0}, {fast, 0.7 * v_esc(m2, m, 150), 0}},
                                         {m, {0, 200, 0}, {0.7 * v_esc(m1, m, 200), 0, 0}},
                                         {m, {500, 0, 0}, {0, 0, 10}}};
  EXPECT_THAT(members(bound_groups(clumps, 2)), ElementsAre(ElementsAre(0, 3), ElementsAre(1, 2)));
}

TEST(BoundGroups, DebrisBetweenGroupsJoinsTheTighterOne) {
  // At rest in the middle of two remnants that pass each other too fast, nearer to the lighter.
  const double m1 = 1e9, m2 = 8e8;
  const std::vector<PointMass> clumps = {
      {m1, {}, {}}, {m2, {1000, 0, 0}, {0, 1, 0}}, {1e5, {900, 0, 0}, {0, 1, 0}}};
  EXPECT_THAT(members(bound_groups(clumps, 2)), ElementsAre(ElementsAre(0), ElementsAre(1, 2)));
}

TEST(BoundGroups, DebrisMayBeHeldByTheSumOfMembersOnly) {
  // Unbound from the first remnant alone, bound to the pair.
  const double m = 1e9, r = 500;
  const double speed = std::sqrt(1.5) * v_esc(m, 0, r);
  const std::vector<PointMass> pair = {
      {m, {-10, 0, 0}, {}}, {m, {10, 0, 0}, {}}, {1, {0, r, 0}, {0, speed, 0}}};
  EXPECT_THAT(members(bound_groups(pair, 2)), ElementsAre(ElementsAre(0, 1, 2)));
  const std::vector<PointMass> single = {pair[0], pair[2]};
  EXPECT_THAT(members(bound_groups(single, 1)), ElementsAre(ElementsAre(0), ElementsAre(1)));
}

TEST(BoundGroups, FirstUnboundDebrisMakesTheSecondGroup) {
  const std::vector<PointMass> clumps = {
      {1e9, {}, {}}, {3e6, {300, 0, 0}, {5, 0, 0}}, {2e6, {0, 300, 0}, {0, 5, 0}}};
  const auto groups = bound_groups(clumps, 1);
  EXPECT_THAT(members(groups), ElementsAre(ElementsAre(0), ElementsAre(1)));
  EXPECT_EQ(groups[1].sum.mass, 3e6);
}

TEST(BoundGroups, GroupsAreSortedByMassWithTheirDebris) {
  // The lighter remnant gathers so much debris that its group is the heavier one.
  std::vector<PointMass> clumps = {{1e9, {}, {}}, {9e8, {1e4, 0, 0}, {5, 0, 0}}};
  for (int i = 0; i < 5; ++i) clumps.push_back({1e8, {1e4, 100.0 + 50 * i, 0}, {5, 0, 0}});
  const auto groups = bound_groups(clumps, 2);
  EXPECT_NEAR(groups[0].sum.mass, 1.4e9, 1);
  EXPECT_THAT(members(groups), ElementsAre(ElementsAre(1, 2, 3, 4, 5, 6), ElementsAre(0)));
}

TEST(BoundGroups, NothingHasNoGroups) { EXPECT_TRUE(bound_groups({}, 0).empty()); }

TEST(BoundGroups, OneBodyIsOneGroup) {
  const std::vector<PointMass> clumps = {{1e9, {}, {}}};
  EXPECT_THAT(members(bound_groups(clumps, 1)), ElementsAre(ElementsAre(0)));
}

}  // namespace
}  // namespace eerie::remnants
