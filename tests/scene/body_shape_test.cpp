#include "solver/scene/body_shape.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"

namespace eerie {
namespace {

using nlohmann::json;

json ellipsoid(double b_over_a, double c_over_a, double turn_deg = 0) {
  return {{"b_over_a", b_over_a}, {"c_over_a", c_over_a}, {"turn_deg", turn_deg}};
}

std::string refusal(const json& scene) {
  try {
    parse_scene(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(BodyShape, HasTheVolumeOfTheSphereAndTheAxesThatWereAskedFor) {
  const BodyShape shape({0.6, 0.4, 0}, {0, 0, 0});
  const Vec3& a = shape.semi_axes();
  EXPECT_NEAR(a.x * a.y * a.z, 1, 1e-14);
  EXPECT_NEAR(a.y / a.x, 0.6, 1e-14);
  EXPECT_NEAR(a.z / a.x, 0.4, 1e-14);
  EXPECT_TRUE(BodyShape({1, 1, 30}, {0, 20, 10}).is_sphere());
}

TEST(BodyShape, PointsItsShortestAxisWhereTheSpinDoesAndItsLongestAsTurned) {
  const auto directions = [](double tilt, double node, double turn) {
    return BodyShape({0.5, 0.5, turn}, {0, tilt, node}).directions();
  };
  const auto is = [](const Vec3& found, const Vec3& wanted) {
    EXPECT_LT(norm(found - wanted), 1e-15);
  };
  is(directions(0, 0, 0)[0], {1, 0, 0});
  is(directions(0, 0, 90)[0], {0, 1, 0});
  is(directions(0, 0, 0)[2], {0, 0, 1});
  is(directions(90, 90, 0)[2], {0, 1, 0});
  is(directions(90, 90, 0)[0], {0, 0, -1});
  const auto tilted = directions(50, 70, 20);
  is(cross(tilted[0], tilted[1]), tilted[2]);
  is(tilted[2] * 1.0, spin({1, 50, 70}) / norm(spin({1, 50, 70})));
}

TEST(BodyShape, MapsItsSurfaceToTheSphere) {
  const BodyShape shape({0.5, 0.3, 40}, {0, 60, 110});
  for (int k = 0; k < 3; ++k) {
    const Vec3 pole = shape.semi_axes()[k] * shape.directions()[static_cast<std::size_t>(k)];
    EXPECT_NEAR(norm(shape.on_sphere(pole)), 1, 1e-14);
  }
  const Vec3 x{0.1, 1.0 / 3, 7};
  EXPECT_EQ(BodyShape().on_sphere(x), x);
}

TEST(Scene, KeepsItsHashWhereBodiesAreSpheres) {
  const Scene plain = parse_scene(json::object());
  EXPECT_EQ(scene_hash(parse_scene({{"target", {{"shape", ellipsoid(1, 1, 40)}}}})),
            scene_hash(plain));
  for (const char* body : {"target", "impactor"}) {
    const Scene one = parse_scene({{body, {{"shape", ellipsoid(0.5, 0.5)}}}});
    const Scene other =
        parse_scene({{body, {{"shape", ellipsoid(0.5, 0.5)}, {"spin", {{"tilt_deg", 90}}}}}});
    EXPECT_NE(scene_hash(one), scene_hash(plain));
    EXPECT_NE(scene_hash(other), scene_hash(one)) << "its axis points elsewhere";
    EXPECT_EQ(scene_hash(parse_scene(to_json(other))), scene_hash(other));
  }
}

TEST(Scene, RefusesAShapeThatFrictionDoesNotHold) {
  const auto with = [](json shape, double phi_d_deg, double period_h = 0) {
    return json{{"target", {{"shape", std::move(shape)}, {"spin", {{"period_h", period_h}}}}},
                {"material", {{"drucker_prager", {{"phi_d_deg", phi_d_deg}}}}}};
  };
  EXPECT_EQ(refusal(with(ellipsoid(0.5, 0.5), 40)), "");
  const std::string said = refusal(with(ellipsoid(0.2, 0.2), 30));
  EXPECT_THAT(said,
              testing::HasSubstr("scene.target.shape with b_over_a = 0.2 and c_over_a = 0.2"));
  EXPECT_THAT(said, testing::HasSubstr("needs a friction angle of"));
  EXPECT_THAT(said, testing::HasSubstr("the material has 30 deg"));
  EXPECT_THAT(refusal(with(ellipsoid(0.3, 0.3), 40, 2.4)), testing::HasSubstr("no weight"));
}

TEST(Scene, RefusesAShapeWhoseShortestAxisIsLongerThanTheMiddleOne) {
  EXPECT_THAT(refusal({{"impactor", {{"shape", ellipsoid(0.5, 0.7)}}}}),
              testing::HasSubstr("impactor.shape.c_over_a = 0.7: must be at most b_over_a = 0.5"));
}

TEST(Scene, RefusesEllipsoidsThatMayTouchAsTheyStart) {
  const json shape = ellipsoid(0.5, 0.5);
  json scene = {{"target", {{"shape", shape}}}, {"impactor", {{"shape", shape}}}};
  EXPECT_EQ(refusal(scene), "");
  scene["impact"]["separation"] = 1.5;
  EXPECT_THAT(refusal(scene), testing::HasSubstr("may touch as they start; give 1.67"));
}

}  // namespace
}  // namespace eerie
