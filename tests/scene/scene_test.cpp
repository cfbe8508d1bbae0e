#include "solver/scene/scene.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"

namespace eerie {
namespace {
using nlohmann::json;

TEST(Scene, WithoutAnyFieldIsThePapersReferenceImpact) {
  const Scene scene = parse_scene(json::object());
  EXPECT_EQ(scene.target.radius_m, 50);
  EXPECT_EQ(scene.impact.q, 1);
  EXPECT_EQ(scene.impact.v_imp_cm_per_s, 20);
  EXPECT_EQ(scene.impact.theta_imp_deg, 15);
  EXPECT_EQ(scene.material.drucker_prager.phi_d_deg, 40);
  EXPECT_EQ(scene.material.tillotson.A_Pa, scene.material.tillotson.B_Pa);
}

TEST(Scene, ReadsBackWhatItWrites) {
  const Scene scene = parse_scene({{"impact", {{"q", 0.25}, {"v_imp_cm_per_s", 12.5}}},
                                   {"material", {{"rheology", "fluid"}}},
                                   {"numerics", {{"seed", 4294967295}}}});
  const json written = to_json(scene);
  EXPECT_EQ(to_json(parse_scene(written)), written);
  EXPECT_EQ(scene_hash(parse_scene(written)), scene_hash(scene));
}

TEST(Scene, HasOneHashForOneNumberHoweverItIsSpelt) {
  const std::string hash =
      scene_hash(parse_scene(json::parse(R"({"impact": {"v_imp_cm_per_s": 30}})")));
  for (const char* text :
       {R"({"impact": {"v_imp_cm_per_s": 30.0}})", R"({"impact": {"v_imp_cm_per_s": 3e1}})",
        R"({"numerics": {"particles_per_target": 5000.0}, "impact": {"v_imp_cm_per_s": 30}})"})
    EXPECT_EQ(scene_hash(parse_scene(json::parse(text))), hash) << text;
}

TEST(Scene, HasAnotherHashForEveryFieldThatDecidesTheResult) {
  const std::string hash = scene_hash(parse_scene(json::object()));
  for (const json& fields :
       {json{{"numerics", {{"seed", 2}}}}, json{{"impact", {{"q", 0.999}}}},
        json{{"end", {{"time_s", 30001}}}}, json{{"numerics", {{"precision", "double"}}}}})
    EXPECT_NE(scene_hash(parse_scene(fields)), hash) << fields;
}

TEST(Scene, IsTheSameJobWhateverItWritesOut) {
  const std::string hash = scene_hash(parse_scene(json::object()));
  EXPECT_EQ(scene_hash(parse_scene({{"output", {{"history_interval_s", 7}}}})), hash);
}

TEST(Scene, RefusesAnImpactorTooSmallToHaveAShape) {
  EXPECT_THROW(
      {
        try {
          parse_scene({{"impact", {{"q", 0.01}}}});
        } catch (const InputError& error) {
          EXPECT_THAT(error.what(), testing::HasSubstr("particles_per_target to 10000"));
          throw;
        }
      },
      InputError);
}

TEST(Scene, NamesPathValueRangeAndMendOfAFault) {
  try {
    parse_scene({{"impact", {{"theta_imp_deg", 95}}}}, "my.json");
    FAIL();
  } catch (const InputError& error) {
    for (const char* part :
         {"my.json.impact.theta_imp_deg", "95", "at least 0", "at most 89", "for example 15"})
      EXPECT_THAT(error.what(), testing::HasSubstr(part));
  }
}

TEST(Scene, GivesBodiesOfTheMassRatioAsked) {
  const Scene scene = parse_scene({{"impact", {{"q", 0.125}}}});
  EXPECT_NEAR(impactor_radius(scene), 25, 1e-9);
  EXPECT_EQ(impactor_particles(scene), 625);
  EXPECT_NEAR(contact_distance(scene), 75, 1e-9);
}

}  // namespace
}  // namespace eerie
