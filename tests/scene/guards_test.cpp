#include "solver/scene/guards.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "tests/support/scenes.hpp"

namespace eerie {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> warnings_of(const json& changes) {
  json scene = {{"numerics", {{"particles_per_target", 5000}}}};
  scene.merge_patch(changes);
  return warnings(parse_scene(scene));
}

TEST(Guards, DefaultsAreInsideEveryLine) { EXPECT_THAT(warnings_of(json::object()), IsEmpty()); }

TEST(Guards, EachLineIsNamedWithFieldValueAndMend) {
  struct Case {
    json changes;
    const char *field, *mend;
  };
  const Case cases[] = {
      {{{"numerics", {{"cfl", 0.7}, {"integrator", "leapfrog"}}}},
       "scene.numerics.cfl = 0.7",
       "0.5"},
      {{{"numerics", {{"scheme", "dual"}, {"cfl", 0.5}, {"viscosity_alpha", 0.3}}}},
       "scene.numerics.cfl = 0.5",
       "0.4"},
      {{{"numerics", {{"cfl", 1.1}, {"integrator", "leapfrog-pece"}}}}, "cfl = 1.1", "0.8"},
      {{{"numerics", {{"cfl", 1.3}, {"integrator", "staggered"}}}}, "cfl = 1.3", "1.1"},
      {{{"numerics", {{"gravity_tolerance", 0.01}}}}, "gravity_tolerance = 0.01", "use 1e-4"},
      {{{"numerics", {{"opening_angle", 0.8}}}}, "opening_angle = 0.8", "use 0.35"},
      {{{"numerics", {{"h_over_spacing", 1.6}}}}, "h_over_spacing = 1.6", "Wendland"},
      {{{"numerics", {{"h_over_spacing", 0.95}}}}, "h_over_spacing = 0.95", "use 1.2"},
      {{{"numerics", {{"viscosity_alpha", 0.02}, {"viscosity_particles", 0}}}},
       "viscosity_alpha = 0.02",
       "0.3"},
      {{{"numerics", {{"viscosity_alpha", 2}, {"viscosity_particles", 0}}}},
       "viscosity_alpha = 2",
       "use 1"},
      {{{"numerics", {{"list_skin", 0.6}}}}, "list_skin = 0.6", "use 0.1"},
      {{{"numerics", {{"particles_per_target", 300}}}}, "particles_per_target = 300", "use 5000"},
      {{{"numerics", {{"gradient", "plain"}}}}, "gradient = \"plain\"", "\"corrected\""},
      {{{"material", {{"drucker_prager", {{"cohesion_Pa", 1000}}}}}},
       "cohesion_Pa = 1000",
       "shear_modulus_Pa"},
      {{{"impact", {{"v_imp_cm_per_s", 100}}}}, "v_imp_cm_per_s = 100", "raise the elastic moduli"},
  };
  for (const Case& c : cases)
    EXPECT_THAT(warnings_of(c.changes),
                ElementsAre(testing::AllOf(HasSubstr(c.field), HasSubstr(c.mend))))
        << c.changes;
}

TEST(Guards, AWendlandKernelMayHaveMoreNeighbours) {
  EXPECT_THAT(warnings_of({{"numerics", {{"kernel", "wendland-c4"}, {"h_over_spacing", 1.6}}}}),
              IsEmpty());
}

TEST(Scene, WhatNoSingleFieldCanSayIsRefused) {
  const auto refused = [](const json& changes) {
    try {
      test::small_scene(changes);
      return std::string("accepted");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  const auto walls = [](json list) { return json{{"environment", {{"walls", std::move(list)}}}}; };
  EXPECT_THAT(refused({{"material", {{"eos", "ideal-gas"}}}}), HasSubstr("material.energy"));
  EXPECT_THAT(refused({{"material", {{"fracture", "grady-kipp"}}}}), HasSubstr("lundborg"));
  EXPECT_THAT(refused({{"material", {{"rheology", "lundborg"}, {"lundborg", {{"Y_M_Pa", 1e6}}}}}}),
              HasSubstr("Y_0_Pa"));
  EXPECT_THAT(refused(walls({{{"face", "x_low"}, {"at_m", 0}}, {{"face", "x_low"}, {"at_m", 1}}})),
              HasSubstr("at most one"));
  EXPECT_THAT(refused(walls({{{"face", "x_low"}, {"at_m", 5}}, {{"face", "x_high"}, {"at_m", 1}}})),
              HasSubstr("exchange"));
  EXPECT_THAT(refused(walls({{{"face", "up"}, {"at_m", 5}}})), HasSubstr("walls[0].face"));
  EXPECT_THAT(refused(walls({{{"at_m", 5}}})), HasSubstr("\"face\" is missing"));
  EXPECT_THAT(refused({{"environment", {{"gravity_m_per_s2", {0, 1}}}}}), HasSubstr("3 entries"));
  EXPECT_THAT(refused({{"environment", {{"gravity_m_per_s2", {0, 1, "down"}}}}}),
              HasSubstr("gravity_m_per_s2[2]"));
  EXPECT_THAT(refused({{"environment", {{"self_gravity", "yes"}}}}), HasSubstr("true or false"));
}

}  // namespace
}  // namespace eerie
