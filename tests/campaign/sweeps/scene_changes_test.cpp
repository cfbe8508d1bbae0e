#include "campaign/sweeps/scene_changes.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace eerie::sweeps {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

const json scene = {
    {"numerics", {{"particles_per_target", 5000}, {"scheme", "closing-gaps"}, {"cfl", 0.6}}},
    {"end", {{"time_s", 50000}}}};

TEST(SceneChanges, SayWhatAFidelityReplacesInAFileAndHowToKeepIt) {
  const SceneChanges changes{.fidelity = "survey"};
  // The scheme is the fidelity's own, and fidelities leave cfl alone.
  EXPECT_THAT(
      changes.replaced(scene, "s.json"),
      ElementsAre("s.json: end.time_s = 50000 gives way to --fidelity survey, which has 100000; "
                  "--set end.time_s=50000 keeps it",
                  "s.json: numerics.particles_per_target = 5000 gives way to --fidelity survey, "
                  "which has 1000; --set numerics.particles_per_target=5000 keeps it"));
  EXPECT_THAT(changes.replaced(json::object(), "s.json"), IsEmpty());
}

TEST(SceneChanges, AreSilentOfFieldsThatSetDecides) {
  const SceneChanges changes{.overrides = {"numerics.particles_per_target=2000", "end.time_s=9"},
                             .fidelity = "survey"};
  EXPECT_THAT(changes.replaced(scene, "s.json"), IsEmpty());
  EXPECT_THAT(SceneChanges{.overrides = {"end.time_s=9"}}.replaced(scene, "s.json"), IsEmpty());
}

TEST(SceneChanges, SayThatTheAutomaticFidelityChoosesWhatDiffersAmongItsRungs) {
  EXPECT_THAT(
      SceneChanges{.fidelity = "auto"}.replaced(scene, "s.json"),
      ElementsAre(testing::HasSubstr("end.time_s = 50000 gives way to --fidelity auto, which has"),
                  "s.json: numerics.particles_per_target = 5000 gives way to --fidelity auto, "
                  "which chooses it"));
}

}  // namespace
}  // namespace eerie::sweeps
