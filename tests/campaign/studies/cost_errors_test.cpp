#include "campaign/studies/cost_errors.hpp"

#include <gmock/gmock.h>

#include "campaign/studies/cost_cases.hpp"
#include "solver/base/error.hpp"

namespace eerie::studies {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

json small_study() {
  return {
      {"name", "small"},
      {"fidelity", "sketch"},
      {"scene", {{"end", {{"time_s", 100}}}}},
      {"seeds", 2},
      {"cases",
       {{{"name", "slow"}, {"scene", {{"impact", {{"v_imp_cm_per_s", 15}}}}}},
        {{"name", "fast"}, {"scene", {{"impact", {{"v_imp_cm_per_s", 24}}}}}}}},
      {"knobs",
       {{{"name", "cfl"},
         {"settings",
          {{{"label", "0.4"}, {"set", {{"numerics.cfl", 0.4}}}},
           {{"label", "1"}, {"set", {{"numerics.cfl", 1.0}}}}}}},
        {{"name", "kernel"},
         {"settings", {{{"label", "C2"}, {"set", {{"numerics.kernel", "wendland-c2"}}}}}}}}},
      {"reference",
       {{"label", "finest"}, {"seeds", 3}, {"set", {{"numerics.particles_per_target", 5000}}}}}};
}

std::string complaint(const json& study) {
  try {
    parse_cost_study(study, "chart.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CostStudy, TurnsOneKnobAtATimeFromTheFidelity) {
  const CostStudy study = parse_cost_study(small_study(), "chart.json");
  ASSERT_EQ(study.settings.size(), 5u);
  const std::vector<CostRun> runs = runs_of(study);
  EXPECT_EQ(runs.size(), 4u * 2 * 2 + 2 * 3);
  for (const CostRun& run : runs) {
    EXPECT_EQ(run.scene.numerics.scheme, "closing-gaps");
    EXPECT_EQ(run.scene.numerics.particles_per_target, run.setting == 4 ? 5000 : 400);
    EXPECT_EQ(run.scene.numerics.kernel, run.setting == 3 ? "wendland-c2" : "cubic-spline");
    EXPECT_EQ(run.scene.impact.v_imp_cm_per_s, run.case_index == 0 ? 15 : 24);
    EXPECT_EQ(run.scene.end.time_s, 100);
    EXPECT_EQ(run.scene.numerics.seed, run.seed);
  }
  for (std::size_t k = 1; k < runs.size(); ++k) EXPECT_LE(runs[k - 1].seed, runs[k].seed);
}

TEST(CostStudy, SaysWhatIsWrongAndWhere) {
  json study = small_study();
  study["knobs"][0]["settings"][1]["set"] = {{"numerics.clf", 1.0}};
  EXPECT_THAT(complaint(study), HasSubstr("cfl 1: scene: the scene has no field \"numerics.clf\""));
  study = small_study();
  study["knobs"][1]["settings"][0]["set"] = {{"numerics.kernel", "gauss"}};
  EXPECT_THAT(complaint(study), HasSubstr("numerics.kernel"));
  study = small_study();
  study.erase("reference");
  EXPECT_THAT(complaint(study), HasSubstr("reference"));
  study = small_study();
  study["fidelity"] = "coarse";
  EXPECT_THAT(complaint(study), HasSubstr("sketch, survey, standard, fine, paper"));
}

/// Results of all runs: b/a is `b_over_a(setting, case)` plus 0.01 for odd seeds, less 0.01 for
/// even ones; the cost is `cost(setting)`.
template <class BOverA, class Cost>
std::vector<CostResult> results(const CostStudy& study, BOverA&& b_over_a, Cost&& cost) {
  std::vector<CostResult> all;
  for (const CostRun& run : runs_of(study)) {
    CostResult r{run, {}, {{.rank = 1, .mass_over_total = 0.9}}, cost(run.setting)};
    r.remnants[0].b_over_a =
        b_over_a(run.setting, run.case_index) + (run.seed % 2 == 1 ? 0.01 : -0.01);
    r.remnants[0].c_over_a = 0.2, r.remnants[0].spin_period_h = 8 + 0.8 * (run.setting == 1);
    r.row.result.outcome_class = "perfect-merging";
    r.row.result.particle_steps = 1e6;
    all.push_back(std::move(r));
  }
  return all;
}

TEST(CostStudy, MeasuresErrorsOverCasesAndTheNoiseOfTheirSeeds) {
  const CostStudy study = parse_cost_study(small_study(), "chart.json");
  // Setting 1 is off by 0.03 in one case and 0.04 in the other; reference seeds 1, 2, 3: + - +.
  const auto points = cost_points(study, results(
                                             study,
                                             [](std::size_t s, std::size_t c) {
                                               return 0.3 + (s == 1 ? (c == 0 ? 0.03 : 0.04) : 0) -
                                                      (s == 4 ? 0.01 / 3 : 0);
                                             },
                                             [](std::size_t s) { return s == 4 ? 100.0 : 10.0; }));
  ASSERT_EQ(points.size(), 5u);
  EXPECT_NEAR(points[1].b_over_a.error, std::sqrt((0.03 * 0.03 + 0.04 * 0.04) / 2), 1e-12);
  EXPECT_NEAR(points[0].b_over_a.error, 0, 1e-12);
  // Squares about the means: 2e-4 with two seeds (4 settings), 8/3e-4 with three; 6 degrees.
  const double variance = (4 * 2e-4 + 8e-4 / 3) / 6;
  EXPECT_NEAR(points[1].b_over_a.noise, std::sqrt(variance * (0.5 + 1.0 / 3)), 1e-12);
  EXPECT_NEAR(points[1].period.error, 0.1, 1e-12);  // 8.8 h for 8 h
  EXPECT_EQ(points[4].b_over_a.error, 0);
  EXPECT_EQ(points[0].class_agreement, 1);
}

TEST(CostStudy, FindsTheCheapestOfWhatIsAsTrueWithinTheNoise) {
  const CostStudy study = parse_cost_study(small_study(), "chart.json");
  const double cost[] = {10, 40, 5, 12, 100};
  const double off[] = {0.001, 0, 0.2, 0.002, 0};
  const auto points = cost_points(
      study,
      results(
          study, [&](std::size_t s, std::size_t) { return 0.3 + off[s] - (s == 4 ? 0.01 / 3 : 0); },
          [&](std::size_t s) { return cost[s]; }));
  EXPECT_TRUE(points[0].frontier);  // errs by less than the noise, as do 1 and 3
  EXPECT_NEAR(points[1].cost_over_frontier, 4, 1e-12);
  EXPECT_NEAR(points[3].cost_over_frontier, 1.2, 1e-12);
  EXPECT_TRUE(points[2].frontier);  // false but cheap
  EXPECT_THAT(cost_csv(study, points), HasSubstr("\"cfl\",\"1\",\"slow, fast\",4,5,1e+06,0.2,"));
}

TEST(CostStudy, HasNoPointsWithoutTheReference) {
  const CostStudy study = parse_cost_study(small_study(), "chart.json");
  auto some = results(
      study, [](std::size_t, std::size_t) { return 0.3; }, [](std::size_t) { return 1.0; });
  std::erase_if(some,
                [](const CostResult& r) { return r.run.setting == 4 && r.run.case_index == 1; });
  EXPECT_THAT(cost_points(study, some), IsEmpty());
}

TEST(CostStudy, ShowsSettingsThatLackACaseApartFromTheFrontier) {
  const CostStudy study = parse_cost_study(small_study(), "chart.json");
  const double cost[] = {10, 40, 1, 12, 100};
  auto some = results(
      study,
      [](std::size_t s, std::size_t c) {
        return 0.3 + (s == 2 && c == 1 ? 0.05 : 0) - (s == 4 ? 0.01 / 3 : 0);
      },
      [&](std::size_t s) { return cost[s]; });
  std::erase_if(some,
                [](const CostResult& r) { return r.run.setting == 2 && r.run.case_index == 0; });
  const auto points = cost_points(study, some);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_FALSE(points[2].whole);
  EXPECT_EQ(points[2].cases, "fast");
  EXPECT_EQ(points[2].runs, 2u);
  EXPECT_NEAR(points[2].b_over_a.error, 0.05, 1e-12);  // of the case that is there
  EXPECT_FALSE(points[2].frontier);
  EXPECT_TRUE(points[0].frontier);  // though the other would be cheaper
  EXPECT_EQ(points[0].cases, "slow, fast");
  EXPECT_THAT(cost_csv(study, points), HasSubstr("\"cfl\",\"1\",\"fast\",2,1,"));
  EXPECT_THAT(figures::accuracy_script(cost_figure(study, points)).text(),
              HasSubstr("some impacts only"));
}

TEST(CostStudy, DrawsKnobsByNameAndTheDefaultAsAStar) {
  const CostStudy study = parse_cost_study(small_study(), "chart.json");
  const figures::AccuracyFigure figure =
      cost_figure(study, cost_points(study, results(
                                                study, [](std::size_t, std::size_t) { return 0.3; },
                                                [](std::size_t) { return 1.0; })));
  ASSERT_EQ(figure.series.size(), 3u);
  EXPECT_TRUE(figure.series[0].is_default);
  EXPECT_EQ(figure.series[1].points.size(), 2u);
  const std::string script = figures::accuracy_script(figure).text();
  EXPECT_THAT(script, HasSubstr("set label \"cfl\""));
  EXPECT_THAT(script, HasSubstr("set label \"frontier: "));
  EXPECT_THAT(script, Not(HasSubstr("some impacts only")));
}

TEST(CostCases, SayWhatEachSettingMakesOfEachImpact) {
  const CostStudy study = parse_cost_study(small_study(), "chart.json");
  auto some = results(
      study, [](std::size_t s, std::size_t c) { return s == 1 && c == 1 ? 0.4 : 0.2; },
      [](std::size_t s) { return s == 4 ? 100.0 : 10.0; });
  std::erase_if(some,
                [](const CostResult& r) { return r.run.setting == 3 && r.run.case_index == 0; });
  for (CostResult& r : some)
    if (r.run.setting == 1 && r.run.seed == 2)  // an EER beside a rounder body
      r.remnants.push_back({.rank = 2, .mass_over_total = 0.1, .b_over_a = 0.25});
  const std::vector<CostCell> cells = cost_cells(study, some);
  ASSERT_EQ(cells.size(), 5u * 2 - 1);
  const CostCell& rounder = cells[3];
  EXPECT_EQ(rounder.setting, 1u);
  EXPECT_EQ(rounder.case_index, 1u);
  EXPECT_EQ(rounder.m_1.runs, 2u);
  EXPECT_NEAR(rounder.b_over_a.mean, 0.4, 1e-12);
  EXPECT_NEAR(rounder.b_over_a.deviation, std::sqrt(2) * 0.01, 1e-12);
  EXPECT_NEAR(rounder.m_1.mean, 0.9, 1e-12);
  EXPECT_EQ(rounder.p_top3_eer, 0.5);
  EXPECT_EQ(cells[2].p_top3_eer, 1);
  const std::string csv = cost_cells_csv(study, cells);
  EXPECT_THAT(csv, HasSubstr("\"cfl\",\"0.4\",fast,2,0.4,0.0141,0.2,0,0.9,0,8.8,0,10,0,0.5,"
                             "perfect-merging 2\n"));
  const figures::MatrixFigure figure = cost_matrix(study, cells);
  EXPECT_THAT(figure.columns, testing::ElementsAre("slow", "fast"));
  ASSERT_EQ(figure.groups.size(), 4u);
  EXPECT_EQ(figure.groups[0].rows.at(0).label, "default");
  EXPECT_EQ(figure.groups[1].name, "cfl");
  EXPECT_EQ(figure.groups[1].rows.at(0).cells.at(1)->text, ".40  .90");
  EXPECT_FALSE(figure.groups[2].rows.at(0).cells.at(0)) << "not run";
}

TEST(CostStudy, WritesTheNamesOfFidelitiesBesideTheirPoints) {
  json document = small_study();
  document.erase("scene");  // the default is the whole sketch
  document["knobs"][0]["settings"][0]["set"] = {{"numerics.particles_per_target", 1000}};
  const CostStudy study = parse_cost_study(document, "chart.json");
  const figures::AccuracyFigure figure = cost_figure(
      study, cost_points(study, results(
                                    study, [](std::size_t, std::size_t) { return 0.3; },
                                    [](std::size_t s) { return s == 0 ? 1.0 : 10.0; })));
  EXPECT_EQ(figure.series[0].points[0].name, "sketch");
  EXPECT_EQ(figure.series[1].points[0].name, "survey");
  EXPECT_EQ(figure.series[1].points[1].name, "");
  const std::string script = figures::accuracy_script(figure).text();
  EXPECT_THAT(script, HasSubstr("set label \"sketch\" at 1,"));
  EXPECT_THAT(script, HasSubstr("set label \"survey\" at 10,"));
}

}  // namespace
}  // namespace eerie::studies
