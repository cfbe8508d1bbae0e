#include "campaign/sweeps/sweep.hpp"

#include <gmock/gmock.h>

#include <set>

#include "campaign/sweeps/job.hpp"
#include "campaign/text/json_file.hpp"
#include "solver/base/error.hpp"
#include "tests/support/paths.hpp"

namespace eerie::sweeps {
namespace {

Sweep sweep_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_sweep(text::parse_json(text, "test.json"), overrides, "test.json");
}

std::string shipped(const std::string& name) {
  return test::source_folder() / "sweeps" / (std::string(name) + ".json");
}

std::set<std::string> hashes(const Sweep& sweep) {
  std::set<std::string> all;
  for (const Scene& scene : expand(sweep)) all.insert(scene_hash(scene));
  return all;
}

TEST(Sweep, OfTable2HasThePapersPointsAndDistinctJobs) {
  const std::pair<const char*, std::size_t> series[] = {{"table2-fig2a", 54}, {"table2-fig2b", 96},
                                                        {"table2-fig4", 96},  {"table2-phi30", 40},
                                                        {"table2-fig6", 66},  {"table2-q025", 66}};
  std::set<std::string> distinct;
  std::size_t points = 0;
  for (const auto& [name, count] : series) {
    const Sweep sweep = load_sweep(shipped(name));
    EXPECT_EQ(sweep.name, name);
    EXPECT_EQ(point_count(sweep), count) << name;
    EXPECT_EQ(identify(expand(sweep)).size(), count) << name;
    points += point_count(sweep);
    distinct.merge(hashes(sweep));
  }
  EXPECT_EQ(points, 418u);
  EXPECT_EQ(distinct.size(), 400u);
}

TEST(Sweep, OfFirstLightCrossesFiveSpeedsWithThreeAngles) {
  const std::vector<Scene> scenes = expand(load_sweep(shipped("first-light")));
  ASSERT_EQ(scenes.size(), 15u);
  std::set<std::pair<double, double>> points;
  for (const Scene& scene : scenes) {
    points.emplace(scene.impact.v_imp_cm_per_s, scene.impact.theta_imp_deg);
    EXPECT_EQ(scene.numerics.particles_per_target, 1000);
    EXPECT_EQ(scene.material.drucker_prager.phi_d_deg, 40);
  }
  EXPECT_EQ(points.size(), 15u);
  EXPECT_TRUE(points.contains({24, 20}));
}

TEST(Sweep, GivesTheSameJobsWhateverTheSpellingOfItsNumbersAndTheOrderOfItsKeys) {
  const Sweep a =
      sweep_of(R"({"name": "s", "scene": {"target": {"radius_m": 50}, "end": {"time_s": 3e4}},
                               "grid": {"q": [1], "v_imp_cm_per_s": [30, 20]}})");
  const Sweep b = sweep_of(R"({"grid": {"v_imp_cm_per_s": [20.0, 3.0e1], "q": [1.0]},
                               "scene": {"end": {"time_s": 30000.0}, "target": {"radius_m": 50.0}}, "name": "s"})");
  EXPECT_EQ(hashes(a), hashes(b));
}

TEST(Sweep, TakesAnyNumericFieldAsAnAxis) {
  const Sweep sweep =
      sweep_of(R"({"name": "s", "grid": {"numerics.seed": {"from": 1, "to": 3, "step": 1},
                                   "material.shear_modulus_Pa": [22700, 0]}})");
  std::set<std::pair<std::int64_t, double>> points;
  for (const Scene& scene : expand(sweep))
    points.emplace(scene.numerics.seed, scene.material.shear_modulus_Pa);
  EXPECT_EQ(points.size(), 6u);
  EXPECT_TRUE(points.contains({3, 22700}));
}

TEST(Sweep, TakesWordsAndFlagsAsAxesAndInPoints) {
  const Sweep sweep = sweep_of(R"({"name": "s",
    "grid": {"numerics.kernel": ["wendland-c2", "cubic-spline"], "v_imp_cm_per_s": [20, 30],
             "numerics.rigid_flight": [false, true]}})");
  std::set<std::tuple<std::string, double, bool>> points;
  for (const Scene& s : expand(sweep))
    points.emplace(s.numerics.kernel, s.impact.v_imp_cm_per_s, s.numerics.rigid_flight);
  EXPECT_EQ(points.size(), 8u);
  const Sweep listed = sweep_of(R"({"name": "s", "points": [
    {"numerics.kernel": "wendland-c2", "q": 1}, {"numerics.kernel": "cubic-spline", "q": 0.5}]})");
  EXPECT_EQ(expand(listed)[1].numerics.kernel, "cubic-spline");
  EXPECT_EQ(expand(listed)[1].impact.q, 0.5);
}

TEST(Sweep, MakesOfEachWordTheJobThatASceneWithThisWordIs) {
  const Sweep sweep = sweep_of(R"({"name": "s",
    "scene": {"numerics": {"particles_per_target": 1000}},
    "grid": {"numerics.scheme": ["closing-gaps", "libersky-petschek-2018"]}})");
  std::set<std::string> single;
  for (const char* scheme : {"closing-gaps", "libersky-petschek-2018"})
    single.merge(hashes(sweep_of(
        R"({"name": "s", "scene": {"numerics": {"particles_per_target": 1000}}, "grid": {"q": [1]}})",
        {std::string("numerics.scheme=") + scheme})));
  EXPECT_EQ(hashes(sweep), single);
  // The default fidelity is meant for scenes without energy, and for these alone.
  const Sweep energies =
      sweep_of(R"({"name": "s", "grid": {"material.energy": ["none", "integrated"]}})");
  EXPECT_TRUE(expand(energies)[0].numerics.rigid_flight);
  EXPECT_FALSE(expand(energies)[1].numerics.rigid_flight);
}

TEST(Sweep, HasADocumentThatIsTheSameSweepAgainWhateverItVaries) {
  for (const char* grid :
       {R"({"numerics.scheme": ["closing-gaps", "dual"], "v_imp_cm_per_s": [20, 30]})",
        R"({"numerics.kernel": ["wendland-c2", "cubic-spline"]})",
        R"({"material.energy": ["none", "integrated"]})",
        R"({"numerics.rigid_flight": [false, true]})",
        R"({"numerics.particles_per_target": [500, 1000]})",
        R"({"end.settled.window_s": [4000, 5000], "end.time_s": [1e5, 2e5]})"}) {
    const Sweep sweep = sweep_of(R"({"name": "s", "grid": )" + std::string(grid) + "}");
    const Sweep again = sweep_of(document(sweep));
    EXPECT_EQ(hashes(again), hashes(sweep)) << grid;
    EXPECT_EQ(document(again), document(sweep)) << grid;
  }
}

TEST(Sweep, IsTheSameDocumentWhenGivenAsRangeOrAsList) {
  const Sweep range = sweep_of(
      R"({"name": "s", "grid": {"q": [1.0], "v_imp_cm_per_s": {"from": 12, "to": 18, "step": 3}}})");
  const Sweep list = sweep_of(
      R"({"name": "s", "grid": {"impact.q": [1], "impact.v_imp_cm_per_s": [12, 15, 18]}})");
  EXPECT_EQ(document(range), document(list));
  EXPECT_NE(document(range), document(sweep_of(R"({"name": "s", "grid": {"q": [1]}})")));
}

TEST(Sweep, TakesPointsThatAreNoGridAndCombinesThemWithOne) {
  const Sweep sweep = sweep_of(R"({"name": "s",
    "points": [{"v_imp_cm_per_s": 12, "q": 1}, {"q": 0.5, "v_imp_cm_per_s": 30}],
    "grid": {"numerics.seed": [1, 2, 3]}})");
  EXPECT_EQ(point_count(sweep), 6u);
  std::vector<std::tuple<double, double, std::int64_t>> points;
  for (const Scene& s : expand(sweep))
    points.emplace_back(s.impact.q, s.impact.v_imp_cm_per_s, s.numerics.seed);
  const std::vector<std::tuple<double, double, std::int64_t>> wanted = {
      {1, 12, 1}, {1, 12, 2}, {1, 12, 3}, {0.5, 30, 1}, {0.5, 30, 2}, {0.5, 30, 3}};
  EXPECT_EQ(points, wanted);
}

TEST(Sweep, MakesTheJobsOfAGridOfItsPoints) {
  const Sweep grid =
      sweep_of(R"({"name": "s", "grid": {"q": [1, 0.5], "v_imp_cm_per_s": [20, 30]}})");
  const Sweep points = sweep_of(R"({"name": "s", "points": [
    {"q": 1, "v_imp_cm_per_s": 20}, {"q": 1, "v_imp_cm_per_s": 30},
    {"q": 0.5, "v_imp_cm_per_s": 20}, {"q": 0.5, "impact.v_imp_cm_per_s": 30.0}]})");
  EXPECT_EQ(hashes(points), hashes(grid));
  EXPECT_EQ(document(points), document(sweep_of(document(points))));
}

TEST(Sweep, IsChangedByOverridesBeforeItExpands) {
  const Sweep sweep = sweep_of(
      R"({"name": "s", "scene": {"numerics": {"seed": 5}}, "grid": {"q": [1, 0.5]}})",
      {"numerics.particles_per_target=400", "numerics.seed=6", "numerics.kernel=wendland-c2"});
  for (const Scene& scene : expand(sweep)) {
    EXPECT_EQ(scene.numerics.particles_per_target, 400);
    EXPECT_EQ(scene.numerics.seed, 6);
    EXPECT_EQ(scene.numerics.kernel, "wendland-c2");
  }
}

struct BadOverride {
  const char* text;
  const char* expected;
};

TEST(Sweep, RefusesOverridesThatMakeNoSense) {
  const BadOverride cases[] = {
      {"numerics.seed", "must be PATH=VALUE"},
      {"=3", "must be PATH=VALUE"},
      {"numerics.sead=3", "the closest are numerics.seed"},
      {"numerics=3", "is a group of fields"},
      {"numerics.seed=", "must be an integer"},
      {"numerics.seed=one", "must be an integer"},
      {"numerics.seed=1.5", "must be an integer"},
      {"numerics.seed=[1]", "must be an integer"},
      {"numerics.cfl=9", "at most 1.5"},
      {"numerics.kernel=gauss", "cubic-spline"},
      {"impact.q=0.5", "is an axis of the grid too"},
      {"q=0.5", "is an axis of the grid too"},
  };
  for (const BadOverride& bad : cases) {
    try {
      sweep_of(R"({"name": "s", "grid": {"q": [1]}})", {bad.text});
      ADD_FAILURE() << bad.text << " was taken";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(bad.expected)) << bad.text;
    }
  }
}

TEST(Sweep, FileThatIsMissingIsBadInputThatNamesIt) {
  EXPECT_THROW(
      {
        try {
          load_sweep("/nowhere/sweep.json");
        } catch (const InputError& error) {
          EXPECT_THAT(error.what(), testing::HasSubstr("/nowhere/sweep.json"));
          throw;
        }
      },
      InputError);
}

}  // namespace
}  // namespace eerie::sweeps
