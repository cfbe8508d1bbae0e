#include "solver/scene/two_materials.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "solver/base/error.hpp"
#include "tests/support/scenes.hpp"

namespace eerie {
namespace {

using nlohmann::json;
using test::refusal;
using test::small_scene;
using testing::HasSubstr;

json own(const json& material, const json& more = json::object()) {
  json scene = {{"impactor", {{"material", material}}}};
  scene.merge_patch(more);
  return scene;
}

TEST(TwoMaterials, AreOneWhereTheImpactorHasNothingOfItsOwn) {
  const Scene plain = small_scene();
  EXPECT_FALSE(has_two_materials(plain));
  EXPECT_FALSE(to_json(plain).contains("impactor"));
  // What is said and is the same changes no name of a job.
  const Scene same =
      small_scene(own({{"rho0_kg_per_m3", 2700}, {"phi_d_deg", 40}, {"cohesion_Pa", 0}}));
  EXPECT_FALSE(has_two_materials(same));
  EXPECT_EQ(scene_hash(same), scene_hash(plain));
}

TEST(TwoMaterials, TakeWhatTheImpactorDoesNotHaveFromTheTarget) {
  const Scene scene = small_scene(own({{"phi_d_deg", 25}}));
  EXPECT_TRUE(has_two_materials(scene));
  EXPECT_FALSE(has_two_densities(scene));
  const Scene::Material m = impactor_material(scene);
  EXPECT_EQ(m.drucker_prager.phi_d_deg, 25);
  EXPECT_EQ(m.rho0_kg_per_m3, 2700);
  EXPECT_EQ(m.drucker_prager.cohesion_Pa, 0);
  EXPECT_EQ(scene.material.drucker_prager.phi_d_deg, 40);
  const json written = to_json(scene);
  EXPECT_EQ(written["impactor"], json({{"material", {{"phi_d_deg", 25}}}}));
  EXPECT_EQ(to_json(parse_scene(written)), written);
}

TEST(TwoMaterials, FollowAnAxisOfTheTargetOnlyWhereTheImpactorSaysNothing) {
  const std::vector<FieldChange> axis{{"/material/drucker_prager/phi_d_deg", 30}};
  const Scene free = changed(small_scene(), axis, "scene");
  EXPECT_EQ(impactor_material(free).drucker_prager.phi_d_deg, 30);
  const Scene held = changed(small_scene(own({{"phi_d_deg", 40}})), axis, "scene");
  EXPECT_EQ(impactor_material(held).drucker_prager.phi_d_deg, 40);
  const Scene set = changed(
      small_scene(), std::vector<FieldChange>{{"/impactor/material/phi_d_deg", 20}}, "scene");
  EXPECT_EQ(impactor_material(set).drucker_prager.phi_d_deg, 20);
}

TEST(TwoMaterials, OfTwoDensitiesHaveTheRadiiOfTheirMasses) {
  const Scene scene = small_scene(own({{"rho0_kg_per_m3", 1350}}));
  EXPECT_NEAR(impactor_radius(scene), 50 * std::cbrt(2.0), 1e-12);
  EXPECT_NEAR(contact_distance(scene), 50 * (1 + std::cbrt(2.0)), 1e-12);
  EXPECT_EQ(lowest_density(scene), 1350);
  // The unit of smoothing lengths is that of the larger particles.
  EXPECT_NEAR(smoothing_length(scene),
              scene.numerics.h_over_spacing * std::cbrt(particle_mass(scene) / 1350), 1e-12);
}

TEST(TwoMaterials, NameTheBoundThatTheyCross) {
  EXPECT_THAT(refusal(own({{"rho0_kg_per_m3", 700}})), HasSubstr("give 800 to 9112.5"));
  EXPECT_THAT(
      refusal(own({{"rho0_kg_per_m3", 1350}}, {{"numerics", {{"artificial_stress", 0.3}}}})),
      HasSubstr("artificial_stress = 0.3"));
  EXPECT_THAT(refusal(own({{"phi_d_deg", 20}},
                          {{"material", {{"rheology", "lundborg"}, {"fracture", "grady-kipp"}}}})),
              HasSubstr("is for rubble"));
  EXPECT_THAT(refusal(own({{"phi_d_deg", 20}}, {{"material", {{"rheology", "fluid"}}}})),
              HasSubstr("rheology \"fluid\""));
  EXPECT_EQ(refusal(own({{"rho0_kg_per_m3", 1350}}, {{"material", {{"rheology", "fluid"}}}})), "");
  EXPECT_THAT(refusal(own({{"phi_d_deg", 95}})), HasSubstr("impactor.material.phi_d_deg = 95"));
  EXPECT_THAT(refusal(own({{"colour", 1}})), HasSubstr("impactor.material.colour"));
}

TEST(TwoMaterials, StandInASpinByTheirOwnFrictionAndDensity) {
  const json spin = {{"impactor", {{"spin", {{"period_h", 2.6}}}}}};
  json weak = spin;
  weak.merge_patch(own({{"phi_d_deg", 20}}));
  EXPECT_EQ(refusal(spin), "");
  EXPECT_THAT(refusal(weak), HasSubstr("friction angle of 20 deg"));
  json thin = spin;
  thin.merge_patch(own({{"rho0_kg_per_m3", 1350}}));
  EXPECT_THAT(refusal(thin), HasSubstr("impactor.spin.period_h"));
}

}  // namespace
}  // namespace eerie
