#include "analysis/ending/steadiness.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "solver/base/constants.hpp"

namespace eerie::ending {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr Scene::Settled tolerances = {800, 0.01, 0.05, 0.05, 0.02, 1e5};

/// Looks every 100 s, the last at `end`, of remnants that `at` gives.
template <class At>
std::vector<RemnantLook> looks(double end, At&& at) {
  std::vector<RemnantLook> all;
  for (double time = 100; time <= end; time += 100)
    for (RemnantLook row : at(time)) {
      row.time_s = time;
      all.push_back(row);
    }
  return all;
}

RemnantLook cigar(double b_over_a = 0.25) { return {0, 1, 0.95, 0.5, 270, b_over_a, 0.2, 0.1}; }

TEST(Settling, IsReachedWhenAWholeWindowWasSteady) {
  const auto steady = [](double) { return std::vector{cigar()}; };
  EXPECT_THAT(unsteadiness(looks(900, steady), tolerances), IsEmpty());
  EXPECT_THAT(unsteadiness(looks(800, steady), tolerances), HasSubstr("not watched"));
  EXPECT_THAT(unsteadiness({}, tolerances), HasSubstr("not watched"));
}

TEST(Settling, WaitsForEachQuantityAndNamesIt) {
  const auto drifting = [](double RemnantLook::*quantity, double first, double last) {
    return looks(900, [=](double time) {
      RemnantLook row = cigar();
      row.*quantity = first + (last - first) * (time - 100) / 800;
      return std::vector{row};
    });
  };
  EXPECT_THAT(unsteadiness(drifting(&RemnantLook::b_over_a, 0.25, 0.261), tolerances),
              HasSubstr("b/a of remnant 1 went from 0.250 to 0.261"));
  EXPECT_THAT(unsteadiness(drifting(&RemnantLook::b_over_a, 0.25, 0.259), tolerances), IsEmpty());
  EXPECT_THAT(unsteadiness(drifting(&RemnantLook::c_over_a, 0.2, 0.22), tolerances),
              HasSubstr("c/a"));
  EXPECT_THAT(unsteadiness(drifting(&RemnantLook::mass_over_total, 0.95, 0.92), tolerances),
              HasSubstr("mass"));
  EXPECT_THAT(unsteadiness(drifting(&RemnantLook::turns_per_h, 0.1, 0.106), tolerances),
              HasSubstr("turns per hour"));
  // One turn in hundreds of hours is no spin to be exact about.
  EXPECT_THAT(unsteadiness(drifting(&RemnantLook::turns_per_h, 0.001, 0.0013), tolerances),
              IsEmpty());
}

TEST(Settling, SeesASwingThatEndsWhereItBegan) {
  const auto swinging = [](double time) {
    return std::vector{cigar(0.25 + 0.02 * std::sin(2 * pi * (time - 100) / 800))};
  };
  EXPECT_THAT(unsteadiness(looks(900, swinging), tolerances), HasSubstr("b/a"));
}

TEST(Settling, FollowsTwoAlikeThatExchangeTheirRanks) {
  // Equal masses within a particle, of different shape; the rank goes to and fro between them.
  const auto pair = [](double time) {
    const double more = std::fmod(time, 200) == 0 ? 0.001 : -0.001;
    RemnantLook target{0, 1, 0.47 + more, 0.9, 120, 0.8, 0.7, 0.1};
    RemnantLook impactor{0, 2, 0.47 - more, 0.1, 140, 0.5, 0.4, 0.2};
    if (more < 0) std::swap(target, impactor), target.rank = 1, impactor.rank = 2;
    return std::vector{target, impactor};
  };
  EXPECT_THAT(unsteadiness(looks(900, pair), tolerances), IsEmpty());
}

TEST(Settling, WaitsWhereTheNumberOfRemnantsChanged) {
  const auto splitting = [](double time) {
    return std::vector<RemnantLook>(time < 500 ? 1 : 2, cigar());
  };
  EXPECT_THAT(unsteadiness(looks(900, splitting), tolerances), HasSubstr("number of remnants"));
  const auto gathering = [](double time) {
    return std::vector{time < 500 ? RemnantLook{} : cigar()};
  };
  EXPECT_THAT(unsteadiness(looks(900, gathering), tolerances), HasSubstr("number of remnants"));
}

TEST(Settling, IsNotReachedWhereALookIsMissing) {
  std::vector<RemnantLook> some = looks(900, [](double) { return std::vector{cigar()}; });
  std::erase_if(some, [](const RemnantLook& row) { return row.time_s == 500; });
  EXPECT_THAT(unsteadiness(some, tolerances), HasSubstr("not watched"));
}

/// A remnant of so much of 1e9 kg, 100 m long.
remnants::Remnant body(int rank, double part, Vec3 x, Vec3 v) {
  remnants::Remnant r;
  r.rank = rank, r.mass = part * 1e9, r.mass_over_total = part, r.x = x, r.v = v;
  r.shape.a = r.shape.b = r.shape.c = 100;
  r.bound_group = 1;
  return r;
}

remnants::Remnants only(std::vector<remnants::Remnant> remnants) {
  remnants::Remnants found;
  for (const remnants::Remnant& r : remnants) found.group_masses.push_back(r.mass);
  found.group_cores = found.group_masses;
  found.remnants = std::move(remnants);
  return found;
}

TEST(Settling, WaitsForRemnantsThatMeetWithinTheHorizon) {
  // Falling towards each other from rest, 1 km apart: the time to 100 m follows from Kepler.
  const remnants::Remnants pair =
      only({body(1, 0.5, {0, 0, 0}, {0, 0, 0}), body(2, 0.5, {1000, 0, 0}, {0, 1e-6, 0})});
  const double mu = newton_G * 1e9, r0 = 1000, x = 0.1;
  const double fall =
      std::sqrt(r0 * r0 * r0 / (2 * mu)) * (std::acos(std::sqrt(x)) + std::sqrt(x * (1 - x)));
  EXPECT_THAT(encounters(pair, 1e9, 1.01 * fall, tolerances), HasSubstr("will meet"));
  EXPECT_THAT(encounters(pair, 1e9, 0.99 * fall, tolerances), IsEmpty());
  // Flying apart faster than they can escape.
  const remnants::Remnants apart =
      only({body(1, 0.5, {0, 0, 0}, {0, 0, 0}), body(2, 0.5, {1000, 0, 0}, {1, 0, 0})});
  EXPECT_THAT(encounters(apart, 1e9, 1e9, tolerances), IsEmpty());
}

TEST(Settling, WaitsForFragmentsThatFallBackWhereTheyAreMany) {
  remnants::Remnants found = only({body(1, 0.9, {0, 0, 0}, {0, 0, 0})});
  const remnants::PointMass falling{0.015e9, {300, 0, 0}, {0, 0, 0}};
  const remnants::PointMass leaving{0.05e9, {0, 300, 0}, {0, 5, 0}};
  found.debris = {leaving, falling};
  EXPECT_THAT(encounters(found, 1e9, 1e5, tolerances), IsEmpty());
  found.debris.push_back(falling);
  EXPECT_THAT(encounters(found, 1e9, 1e5, tolerances), HasSubstr("0.030 of the mass will fall"));
}

TEST(Settling, TakesRemnantsTooSmallToWatchForFragments) {
  remnants::Remnants found =
      only({body(1, 0.9, {0, 0, 0}, {0, 0, 0}), body(2, 0.03, {300, 0, 0}, {0, 0, 0})});
  EXPECT_THAT(encounters(found, 1e9, 1e5, tolerances), HasSubstr("will fall back"));
  EXPECT_EQ(look(5, found, tolerances).size(), 1u);
}

TEST(Settling, WaitsForDebrisThatWillGatherToARemnant) {
  remnants::Remnants found;
  found.group_masses = {0.4e9}, found.group_cores = {0.01e9};
  EXPECT_THAT(encounters(found, 1e9, 1e5, tolerances), HasSubstr("has not gathered"));
  found.group_cores = {0.39e9};
  EXPECT_THAT(encounters(found, 1e9, 1e5, tolerances), IsEmpty());
}

TEST(LatePhase, BeginsWhenRemnantsHardlyMoveWhichIsSoonerThanWhenTheyHaveSettled) {
  // 0.025 in b/a over half a window: more than settling allows, less than three times as much.
  const auto relaxing = [](double time) {
    return std::vector{cigar(0.30 - 0.025 * (time - 100) / 400)};
  };
  const std::vector<RemnantLook> rows = looks(500, relaxing);
  const remnants::Remnants alone = only({body(1, 0.95, {0, 0, 0}, {0, 0, 0})});
  EXPECT_THAT(liveliness(rows, alone, 1e5, 0.8, tolerances), IsEmpty());
  EXPECT_THAT(unsteadiness(rows, tolerances), HasSubstr("not watched"));
  const auto falling = [](double time) {
    return std::vector{cigar(0.30 - 0.035 * (time - 100) / 400)};
  };
  EXPECT_THAT(liveliness(looks(500, falling), alone, 1e5, 0.8, tolerances), HasSubstr("b/a"));
}

TEST(LatePhase, WaitsForAFastEncounter) {
  const std::vector<RemnantLook> rows = looks(500, [](double) {
    return std::vector{RemnantLook{0, 1, 0.5, 1, 100, 1, 1, 0},
                       RemnantLook{0, 2, 0.5, 0, 100, 1, 1, 0}};
  });
  // At 1 m/s towards each other: gravity adds little.
  const remnants::Remnants pair =
      only({body(1, 0.5, {0, 0, 0}, {0, 0, 0}), body(2, 0.5, {1000, 0, 0}, {-1, 0, 0})});
  EXPECT_THAT(liveliness(rows, pair, 1e5, 3, tolerances), HasSubstr("will meet at 1.0"));
  EXPECT_THAT(liveliness(rows, pair, 1e5, 11, tolerances), IsEmpty());
  EXPECT_THAT(liveliness(rows, pair, 500, 3, tolerances), IsEmpty());  // they meet after 900 s
}

TEST(Settling, LooksNoFurtherThanTheEndOfTheRun) {
  const Scene::End end = {60000, 0, tolerances};
  EXPECT_EQ(horizon(end, 20000), 40000);
  EXPECT_EQ(horizon({60000, 90000, tolerances}, 20000), 70000);
  EXPECT_EQ(horizon({1e6, 0, tolerances}, 20000), tolerances.horizon_s);
}

}  // namespace
}  // namespace eerie::ending
