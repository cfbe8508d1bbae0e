#include "solver/scene/tide.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "solver/base/constants.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/guards.hpp"
#include "tests/support/scenes.hpp"

namespace eerie {
namespace {

using nlohmann::json;
using test::refusal;
using testing::HasSubstr;

/// About Dinkinesh.
json primary(const json& changes = json::object()) {
  json given = {{"mass_kg", 4.95e11}, {"radius_m", 360}, {"distance_m", 1500}};
  given.merge_patch(changes);
  return {{"environment", {{"primary", given}}}};
}

Scene::Primary fields(double azimuth_deg = 0, bool retrograde = false) {
  return {4.95e11, 360, 1500, azimuth_deg, retrograde};
}

TEST(Tide, IsNothingWithoutAPrimary) {
  const Scene scene = test::small_scene();
  EXPECT_FALSE(has_primary(scene));
  const Tide tide(scene.environment.primary);
  EXPECT_EQ(tide.acceleration({1, 2, 3}, tide.place(4)), Vec3{});
  EXPECT_EQ(hill_radius(scene), std::numeric_limits<double>::infinity());
}

TEST(Tide, IsThePullHereLessThePullInTheMiddle) {
  const Tide tide(fields());
  const double G_M = newton_G * 4.95e11;
  // On the line to the primary and square to it, by hand.
  const Vec3 near = tide.acceleration({100, 0, 0}, tide.place(0)),
             side = tide.acceleration({0, 0, 100}, tide.place(0));
  EXPECT_NEAR(near.x, G_M / (1400.0 * 1400) - G_M / (1500.0 * 1500), 1e-18);
  EXPECT_EQ(near.y, 0);
  const double away = std::hypot(1500, 100);
  EXPECT_NEAR(side.z, -G_M * 100 / std::pow(away, 3), 1e-18);
  EXPECT_NEAR(side.x, G_M * 1500 / std::pow(away, 3) - G_M / (1500.0 * 1500), 1e-18);
}

TEST(Tide, OfAFarPrimaryStretchesTwiceAsMuchAsItSqueezes) {
  Scene::Primary far = fields();
  far.distance_m = 1.5e6, far.mass_kg = 4.95e20;
  const double mu = newton_G * far.mass_kg / std::pow(far.distance_m, 3);
  const Tide tide(far);
  EXPECT_NEAR(tide.acceleration({10, 0, 0}, tide.place(0)).x / (2 * mu * 10), 1, 1e-4);
  EXPECT_NEAR(tide.acceleration({0, 10, 0}, tide.place(0)).y / (-mu * 10), 1, 1e-4);
  EXPECT_NEAR(tide.acceleration({0, 0, 10}, tide.place(0)).z / (-mu * 10), 1, 1e-4);
}

TEST(Tide, TurnsWithThePeriodOfKeplersLaw) {
  const double period = 2 * pi * std::sqrt(std::pow(1500, 3) / (newton_G * 4.95e11));
  for (const bool retrograde : {false, true}) {
    const Tide tide(fields(30, retrograde));
    const Vec3 at_start = tide.place(0), later = tide.place(period / 4);
    EXPECT_NEAR(std::atan2(at_start.y, at_start.x), radians(30), 1e-12);
    EXPECT_NEAR(dot(at_start, later), 0, 1e-6);
    EXPECT_EQ(cross(at_start, later).z > 0, !retrograde);
    EXPECT_NEAR(norm(tide.place(period) - at_start), 0, 1e-6);
  }
}

TEST(Tide, IsFiniteInsideThePrimary) {
  const Tide tide(fields());
  const Vec3 middle = tide.acceleration(tide.place(0), tide.place(0));
  EXPECT_NEAR(middle.x, -newton_G * 4.95e11 / (1500.0 * 1500), 1e-18);
}

TEST(Primary, LeavesScenesWithoutItTheirNames) {
  const Scene plain = test::small_scene();
  EXPECT_FALSE(to_json(plain)["environment"].contains("primary"));
  const Scene with = test::small_scene(primary());
  EXPECT_NE(scene_hash(with), scene_hash(plain));
  EXPECT_EQ(scene_hash(without_primary(with)), scene_hash(plain));
  EXPECT_EQ(scene_hash(parse_scene(to_json(with))), scene_hash(with));
}

TEST(Primary, IsRefusedWhereItCannotBe) {
  EXPECT_THAT(refusal(primary({{"radius_m", 0}})), HasSubstr("primary.radius_m = 0"));
  EXPECT_THAT(refusal(primary({{"distance_m", 400}})), HasSubstr("distance_m = 400"));
  json alone = primary();
  alone["environment"]["self_gravity"] = false;
  EXPECT_THAT(refusal(alone), HasSubstr("self_gravity = false"));
  EXPECT_THAT(refusal(primary({{"mass", 1}})), HasSubstr("no such field"));
}

TEST(Primary, ThatPullsBodiesApartIsWarnedOf) {
  EXPECT_THAT(warnings(test::small_scene(primary({{"distance_m", 600}}))),
              testing::Contains(HasSubstr("Hill radius")));
  EXPECT_THAT(warnings(test::small_scene(primary())),
              testing::Not(testing::Contains(HasSubstr("Hill radius"))));
  // Two bodies of 1.4137e9 kg.
  EXPECT_NEAR(hill_radius(test::small_scene(primary())), 1500 / std::cbrt(3 * 4.95e11 / 2.8274e9),
              0.1);
}

}  // namespace
}  // namespace eerie
