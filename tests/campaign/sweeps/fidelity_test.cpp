#include "campaign/sweeps/fidelity.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "campaign/sweeps/job.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "solver/base/error.hpp"

namespace eerie::sweeps {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::ThrowsMessage;

Sweep sweep_with(const json& scene, std::vector<std::string> overrides) {
  return parse_sweep({{"name", "s"}, {"scene", scene}, {"grid", {{"q", {1}}}}}, overrides,
                     "s.json");
}

TEST(Fidelity, GoesBeforeTheFileAndBehindSet) {
  std::vector<std::string> overrides = overrides_of_fidelity("survey");
  const json file = {{"numerics", {{"particles_per_target", 5000}, {"cfl", 0.6}}},
                     {"end", {{"time_s", 50000}}}};
  const Scene survey = expand(sweep_with(file, overrides)).front();
  EXPECT_EQ(survey.numerics.particles_per_target, 1000);
  EXPECT_EQ(survey.numerics.scheme, "closing-gaps");
  EXPECT_EQ(survey.end.time_s, 100000);
  EXPECT_GT(survey.end.settled.window_s, 0);
  EXPECT_EQ(survey.numerics.cfl, 0.6);  // a field that fidelities leave alone
  overrides.push_back("numerics.particles_per_target=2000");
  EXPECT_EQ(expand(sweep_with(file, overrides)).front().numerics.particles_per_target, 2000);
}

TEST(Fidelity, IsTheDefaultBehindTheFileWhereThatNamesNoScheme) {
  const Scene bare = expand(sweep_with(json::object(), {})).front();
  EXPECT_EQ(fidelity_of(to_json(bare)), "standard");
  const json file = {{"numerics", {{"particles_per_target", 1000}}}};
  EXPECT_EQ(fidelity_of(to_json(expand(sweep_with(file, {})).front())), "survey");
  EXPECT_THAT(departures(file, "s.json"),
              testing::ElementsAre("s.json: numerics.particles_per_target = 1000, where fidelity "
                                   "\"standard\" has 5000"));
  for (const json& own : {json{{"numerics", {{"scheme", "libersky-petschek-2018"}}}},
                          json{{"environment", {{"self_gravity", false}}}},
                          json{{"material", {{"energy", "integrated"}}}}}) {
    EXPECT_EQ(over_default_fidelity(own), own);
    EXPECT_THAT(departures(own, "s.json"), testing::IsEmpty());
    EXPECT_EQ(expand(sweep_with(own, {})).front().numerics.late_sound_speed, 1);
  }
}

TEST(Fidelity, IsARungBetweenACheaperAndAFinerOne) {
  EXPECT_EQ(rung_above("sketch"), "survey");
  EXPECT_EQ(rung_above("standard"), "fine");
  for (const char* last : {"fine", "paper", ""}) EXPECT_EQ(rung_above(last), "") << last;
  EXPECT_THAT(cheaper_rung("standard"),
              testing::StartsWith("--fidelity survey takes 12 % of that"));
  for (const char* lowest : {"sketch", "paper", ""}) EXPECT_EQ(cheaper_rung(lowest), "") << lowest;
  double cost = 0, error = 1;
  for (const Fidelity& fidelity : fidelities) {
    if (!fidelity.is_rung) continue;
    EXPECT_GT(fidelity.core_seconds, cost) << fidelity.name;
    EXPECT_LT(fidelity.error, error) << fidelity.name;
    cost = fidelity.core_seconds, error = fidelity.error;
  }
}

TEST(Fidelity, MayHaveAFieldThatTheGridVaries) {
  const Sweep sweep = parse_sweep(
      {{"name", "s"}, {"grid", {{"numerics.particles_per_target", {500, 1000}}}}}, {}, "s.json");
  const std::vector<Scene> scenes = expand(sweep);
  EXPECT_EQ(scenes[0].numerics.particles_per_target, 500);
  EXPECT_EQ(scenes[1].numerics.late_sound_speed, 0.125);
}

TEST(Fidelity, IsKnownByItsSettingsWhateverImpactAndSeed) {
  for (const Fidelity& fidelity : fidelities) {
    const Scene scene =
        expand(sweep_with({{"numerics", {{"seed", 7}}}, {"impact", {{"v_imp_cm_per_s", 33}}}},
                          overrides_of_fidelity(fidelity.name)))
            .front();
    EXPECT_EQ(fidelity_of(to_json(scene)), fidelity.name);
    EXPECT_EQ(new_job(scene).fidelity, fidelity.name);
  }
  EXPECT_EQ(fidelity_of(to_json(parse_scene(json::object()))), "");
  const Scene other =
      expand(sweep_with({{"numerics", {{"cfl", 0.3}}}}, overrides_of_fidelity("survey"))).front();
  EXPECT_EQ(fidelity_of(to_json(other)), "");
}

TEST(Fidelity, OfThePaperIsThePapers) {
  const Scene paper = expand(sweep_with(json::object(), overrides_of_fidelity("paper"))).front();
  EXPECT_EQ(paper.numerics.particles_per_target, 50000);
  EXPECT_EQ(paper.numerics.scheme, "libersky-petschek-2018");
  EXPECT_EQ(paper.end.time_s, 1e5);
  EXPECT_EQ(paper.end.settled.window_s, 4000);
  EXPECT_EQ(paper.end.settled.shape, 0.0015);
}

TEST(Fidelity, ThatIsNoneIsBadInputThatNamesThoseThereAre) {
  EXPECT_THAT([] { overrides_of_fidelity("finer"); },
              ThrowsMessage<InputError>(HasSubstr(
                  "--fidelity finer: must be one of sketch, survey, standard, fine, paper")));
}

TEST(Fidelity, AutoIsNoneOfThem) {
  EXPECT_THAT([] { overrides_of_fidelity("auto"); },
              ThrowsMessage<InputError>(HasSubstr("only `eerie run` chooses by itself")));
}

TEST(Fidelity, IsRefusedWhereTheGridVariesItsFields) {
  const json sweep = {{"name", "s"}, {"grid", {{"numerics.particles_per_target", {500, 1000}}}}};
  EXPECT_THAT([&] { parse_sweep(sweep, overrides_of_fidelity("sketch"), "s.json"); },
              ThrowsMessage<InputError>(HasSubstr("--fidelity")));
}

}  // namespace
}  // namespace eerie::sweeps
