#include "solver/scene/scene.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/scene/schemes.hpp"

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

TEST(Scene, ReadsBackAFieldThatIsOffThoughItsSchemeTurnsItOn) {
  const std::pair<const char*, json> fields[] = {
      {"void_density", 0}, {"void_density", 0.9}, {"voids", "all"},        {"voids", "gaps"},
      {"flow_mach", 0},    {"flow_mach", 0.05},   {"rigid_flight", false}, {"rigid_flight", true}};
  for (const Scheme& scheme : schemes)
    for (const auto& [field, value] : fields) {
      const json numerics = {{"scheme", scheme.token}, {"late_sound_speed", 0.125}, {field, value}};
      const Scene scene =
          parse_scene({{"numerics", numerics}, {"end", {{"settled", {{"window_s", 4000}}}}}});
      const Scene again = parse_scene(to_json(scene));
      EXPECT_EQ(scene_hash(again), scene_hash(scene)) << numerics;
      EXPECT_EQ(again.numerics.void_density, scene.numerics.void_density) << numerics;
      EXPECT_EQ(again.numerics.flow_mach, scene.numerics.flow_mach) << numerics;
      EXPECT_EQ(again.numerics.rigid_flight, scene.numerics.rigid_flight) << numerics;
      if (scene.numerics.void_density == 0) continue;  // there, the kind of voids decides nothing
      EXPECT_EQ(again.numerics.voids, scene.numerics.voids) << numerics;
    }
}

TEST(Scene, KeepsItsHashWhereNoBodySpins) {
  const Scene plain = parse_scene(json::object());
  const Scene still = parse_scene({{"target", {{"spin", {{"period_h", 0}, {"tilt_deg", 30}}}}},
                                   {"impactor", {{"spin", {{"period_h", 0}}}}}});
  EXPECT_EQ(scene_hash(still), scene_hash(plain));
  for (const char* body : {"target", "impactor"}) {
    const Scene turning = parse_scene({{body, {{"spin", {{"period_h", 6}, {"tilt_deg", 180}}}}}});
    EXPECT_NE(scene_hash(turning), scene_hash(plain));
    EXPECT_EQ(scene_hash(parse_scene(to_json(turning))), scene_hash(turning));
  }
}

TEST(Scene, RefusesASpinThatFrictionCannotHoldAndNamesTheLimit) {
  const auto with = [](double period_h, json material = json::object()) {
    return json{{"impactor", {{"spin", {{"period_h", period_h}}}}}, {"material", material}};
  };
  const auto refusal = [&](const json& scene) {
    try {
      parse_scene(scene);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal(with(2)),
              testing::HasSubstr("impactor.spin.period_h = 2: at a friction angle of 40"));
  EXPECT_THAT(refusal(with(2)), testing::HasSubstr("no shorter period than 2.338 h"));
  EXPECT_EQ(refusal(with(2.4)), "");
  EXPECT_EQ(refusal(with(2, {{"drucker_prager", {{"cohesion_Pa", 10}}}})), "");
  EXPECT_THAT(refusal(with(20, {{"rheology", "fluid"}})), testing::HasSubstr("without friction"));
}

TEST(Scene, TakesDefaultsFromItsSchemeUnlessItSaysOtherwise) {
  const Scene paper = parse_scene({{"numerics", {{"scheme", "libersky-petschek-2018"}}}});
  EXPECT_EQ(paper.numerics.gradient, "corrected-rate");
  EXPECT_EQ(paper.numerics.h_over_spacing, 1);
  const Scene changed =
      parse_scene({{"numerics", {{"scheme", "libersky-petschek-2018"}, {"h_over_spacing", 1.1}}}});
  EXPECT_EQ(changed.numerics.h_over_spacing, 1.1);
  EXPECT_EQ(changed.numerics.gradient, "corrected-rate");
  const json written = to_json(changed);
  EXPECT_EQ(to_json(parse_scene(written)), written);
}

TEST(Scene, HasTheNumericsOfTheSchemeThatItsSchemeStandsOn) {
  json numerics = to_json(parse_scene({{"numerics", {{"scheme", "closing-voids"}}}}))["numerics"];
  EXPECT_EQ(numerics["void_density"], 0.95);
  numerics.erase("void_density");
  numerics["scheme"] = "viscosity-50000";
  EXPECT_EQ(numerics,
            to_json(parse_scene({{"numerics", {{"scheme", "viscosity-50000"}}}}))["numerics"]);
}

TEST(Scene, HasTheViscosityOfThePaperAtAnyParticleNumber) {
  // alpha h = 1 x one spacing of 50,000 particles in a ball of 50 m, 2.19 m.
  for (const int n : {1000, 5000, 50000}) {
    const Scene scene =
        parse_scene({{"numerics", {{"scheme", "viscosity-50000"}, {"particles_per_target", n}}}});
    const double ratio = viscosity_length_ratio(scene), h = smoothing_length(scene);
    EXPECT_NEAR(scene.numerics.viscosity_alpha * ratio * h, 2.188, 0.001) << n;
    EXPECT_NEAR(scene.numerics.viscosity_beta * ratio * ratio * h * h, 2 * 2.188 * 2.188, 0.005);
  }
  EXPECT_EQ(viscosity_length_ratio(parse_scene({{"numerics", {{"viscosity_particles", 0}}}})), 1);
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

TEST(Scene, KeepsTheHashOfResultsFromBeforeItCouldSettle) {
  const Scene first_light = parse_scene(json::parse(
      R"({"numerics": {"scheme": "dual", "particles_per_target": 1000}, "end": {"time_s": 30000},
          "impact": {"q": 1, "v_imp_cm_per_s": 15, "theta_imp_deg": 10},
          "material": {"drucker_prager": {"phi_d_deg": 40}}})"));
  EXPECT_EQ(scene_hash(first_light),
            "c98a38ca5f10ae0c01dc84cca44892994234cde0cdad6056f6c3ac3950cb0407");
  EXPECT_EQ(to_json(first_light)["numerics"]["late_sound_speed"], 1);
  // Tolerances of what is off are none.
  json off = to_json(first_light);
  off["end"]["settled"]["shape"] = 0.5;
  EXPECT_EQ(scene_hash(parse_scene(off)), scene_hash(first_light));
  off["end"]["settled"]["window_s"] = 4000;
  EXPECT_NE(scene_hash(parse_scene(off)), scene_hash(first_light));
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

TEST(Scene, AnImpactWhoseBodiesWereNeverApartIsRefusedWithASpeedThatWillDo) {
  const auto scene = [](double radius_m, double v_imp, double theta, double separation) {
    return parse_scene(
        {{"target", {{"radius_m", radius_m}}},
         {"impact",
          {{"v_imp_cm_per_s", v_imp}, {"theta_imp_deg", theta}, {"separation", separation}}}});
  };
  try {
    scene(50, 3, 45, 2);
    FAIL() << "it was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("scene.impact.v_imp_cm_per_s = 3: bodies of 50 m"));
  }
  EXPECT_THROW(scene(500'000, 20, 45, 2), InputError);
  EXPECT_THROW(changed(scene(50, 20, 45, 2),
                       std::vector<FieldChange>{{"/impact/v_imp_cm_per_s", 3}}, "scene"),
               InputError);
  // Head-on from the distance d of the centres, touching at c: v^2 = 2 G M (1 / c - 1 / d). Two
  // bodies of 50 m and 2700 kg/m^3 from twice to once 100 m apart: v_esc / sqrt(2), 4.343 cm/s.
  EXPECT_THROW(scene(50, 4.34, 0, 2), InputError);
  EXPECT_NO_THROW(scene(50, 4.35, 0, 2));
  EXPECT_NO_THROW(scene(50, 3, 0, 1.3));
}

}  // namespace
}  // namespace eerie
