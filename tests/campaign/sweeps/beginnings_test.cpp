#include "campaign/sweeps/beginnings.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "tests/support/scenes.hpp"

namespace eerie::sweeps {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string refusal(const json& changes) {
  const Scene scenes[] = {test::small_scene(), test::small_scene(changes)};
  try {
    require_beginnings(scenes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Head-on at little more than the escape speed, with a primary near by.
json slow(double azimuth_deg) {
  return {{"impact", {{"v_imp_cm_per_s", 5.2}, {"theta_imp_deg", 0}, {"separation", 2}}},
          {"environment",
           {{"primary",
             {{"mass_kg", 4.95e11},
              {"radius_m", 300},
              {"distance_m", 720},
              {"azimuth_deg", azimuth_deg}}}}}};
}

TEST(Beginnings, OfBodiesThatTheTideHoldsTogetherAreRefused) {
  // Along the line to the primary the tide pulls bodies apart, across it pushes them together.
  EXPECT_EQ(refusal(slow(0)), "");
  EXPECT_THAT(refusal(slow(90)), HasSubstr("never 200 m apart"));
}

TEST(Beginnings, OfRemnantsThatAreNotThereAreRefused) {
  EXPECT_THAT(
      refusal({{"target",
                {{"remnant", {{"file", "/no/egg.hdf5"}, {"sha256", std::string(64, 'a')}}}}}}),
      HasSubstr("/no/egg.hdf5"));
}

}  // namespace
}  // namespace eerie::sweeps
