#include "analysis/drawing/impact_words.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace eerie::drawing {
namespace {

using nlohmann::json;

json reference_impact() {
  return {{"impact", {{"q", 1}, {"v_imp_cm_per_s", 20}, {"theta_imp_deg", 15}}}};
}

/// Whether the title of an impact ends with these letters, whatever escapes they need.
testing::AssertionResult ends_with(const json& scene, const std::string& letters) {
  const std::string title = impact_words(parse_scene(scene)).in_script();
  if (title.ends_with(in_quotes(letters).in_script().substr(1))) return testing::AssertionSuccess();
  return testing::AssertionFailure() << title;
}

TEST(ImpactWords, AnImpactByDefaultEndsWithItsSeed) {
  EXPECT_TRUE(ends_with(reference_impact(), ", seed 1"));
}

TEST(ImpactWords, MatterThatIsNotAsByDefaultIsToldByTheNamesThatSetTakes) {
  json scene = reference_impact();
  scene["material"]["tillotson"]["A_Pa"] = 2.67e5;
  EXPECT_TRUE(ends_with(scene, "seed 1; material.tillotson.A_Pa=267000"));
}

TEST(ImpactWords, AnImpactorOfAnotherMaterialIsToldToo) {
  json scene = reference_impact();
  scene["impactor"]["material"]["phi_d_deg"] = 30;
  EXPECT_TRUE(ends_with(scene, "seed 1; impactor.material.phi_d_deg=30"));
}

TEST(ImpactWords, OfManyFieldsTwoAreToldAndTheOthersCounted) {
  json scene = reference_impact();
  scene["material"]["tillotson"] = {{"A_Pa", 2.67e5}, {"B_Pa", 2.67e5}, {"a", 0.4}};
  EXPECT_TRUE(ends_with(scene,
                        "seed 1; material.tillotson.A_Pa=267000, "
                        "material.tillotson.B_Pa=267000 and 1 more"));
}

TEST(ImpactWords, NumericsAndTheFrictionThatTheTitleHasAreNotToldTwice) {
  json scene = reference_impact();
  scene["material"]["drucker_prager"]["phi_d_deg"] = 50;
  scene["numerics"] = {{"particles_per_target", 1000}, {"seed", 3}, {"cfl", 0.5}};
  scene["end"]["time_s"] = 1000;
  EXPECT_TRUE(ends_with(scene, ", seed 3"));
}

}  // namespace
}  // namespace eerie::drawing
