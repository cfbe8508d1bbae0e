#include "campaign/studies/convergence_study.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "campaign/job_folder/history.hpp"
#include "campaign/studies/convergence_diagnosis.hpp"
#include "campaign/studies/convergence_results.hpp"
#include "campaign/sweeps/job.hpp"
#include "solver/base/error.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::studies {
namespace {
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

json small_study() {
  return {{"name", "small"},
          {"scene", {{"end", {{"time_s", 100}}}, {"impact", {{"v_imp_cm_per_s", 18}}}}},
          {"schemes", {"dual", "shear-free"}},
          {"cases",
           {{{"name", "slow"}, {"scene", {{"impact", {{"theta_imp_deg", 10}}}}}},
            {{"name", "fast"},
             {"scene", {{"impact", {{"v_imp_cm_per_s", 24}}}}},
             {"published", {{"b_over_a", 0.27}}}}}},
          {"ladder",
           {{{"particles_per_target", 300}, {"seeds", 4}},
            {{"particles_per_target", 600}, {"seeds", 2}, {"cases", {"fast"}}}}}};
}

std::string complaint(const json& study) {
  try {
    parse_convergence_study(study, "study.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ConvergenceStudy, GivesEveryCaseTheScenesFieldsAndItsOwnOnTop) {
  const ConvergenceStudy study = parse_convergence_study(small_study(), "study.json");
  for (const ConvergenceRun& run : runs_of(study)) {
    EXPECT_EQ(run.scene.impact.v_imp_cm_per_s, run.case_name == "fast" ? 24 : 18);
    EXPECT_EQ(run.scene.impact.theta_imp_deg, run.case_name == "fast" ? 15 : 10);
    EXPECT_EQ(run.scene.numerics.scheme, run.scheme);
    EXPECT_EQ(run.scene.numerics.seed, run.seed);
  }
  EXPECT_EQ(study.cases[1].published.b_over_a, 0.27);
  EXPECT_EQ(study.cases[0].published.b_over_a, std::nullopt);
}

TEST(ConvergenceStudy, GivesTheRunsOfASchemeItsFieldsOverAllOthers) {
  json given = small_study();
  given["by_scheme"]["shear-free"] = {{"end", {{"time_s", 70}}},
                                      {"impact", {{"v_imp_cm_per_s", 30}}}};
  for (const ConvergenceRun& run : runs_of(parse_convergence_study(given, "study.json"))) {
    const bool own = run.scheme == "shear-free";
    EXPECT_EQ(run.scene.end.time_s, own ? 70 : 100);
    EXPECT_EQ(run.scene.impact.v_imp_cm_per_s, own ? 30 : run.case_name == "fast" ? 24 : 18);
    EXPECT_EQ(run.scene.impact.theta_imp_deg, run.case_name == "fast" ? 15 : 10);
  }
  given["by_scheme"]["shear-freee"] = json::object();
  EXPECT_THAT(complaint(given), HasSubstr("by_scheme names the scheme \"shear-freee\"; the "
                                          "schemes are dual, shear-free"));
}

TEST(ConvergenceStudy, RunsWhatIsWorthMostForItsCostFirst) {
  const auto runs = runs_of(parse_convergence_study(small_study(), "study.json"));
  ASSERT_EQ(runs.size(), 4u * 2 * 2 + 2u * 1 * 2);
  std::vector<std::pair<std::int64_t, std::int64_t>> order;  // particles and seed
  for (const ConvergenceRun& run : runs)
    if (order.empty() || order.back() != std::pair(run.particles_per_target, run.seed))
      order.emplace_back(run.particles_per_target, run.seed);
  // 2^(4/3) = 2.5: the first seed of the dear rung comes between the second and third of the cheap.
  EXPECT_THAT(order, ElementsAre(std::pair(300, 1), std::pair(300, 2), std::pair(600, 1),
                                 std::pair(300, 3), std::pair(300, 4), std::pair(600, 2)));
}

TEST(ConvergenceStudy, RunsEachOnceThoughRungsShareAParticleNumber) {
  json more = small_study();
  more["ladder"].push_back({{"particles_per_target", 300}, {"seeds", 5}});
  const auto count = [](const json& study) {
    return runs_of(parse_convergence_study(study, "study.json")).size();
  };
  EXPECT_EQ(count(more), count(small_study()) + 4);  // the fifth seed, two cases, two schemes
}

TEST(ConvergenceStudy, ComplaintsNameTheFieldAndTheMend) {
  json study = small_study();
  study["ladder"][1]["cases"] = {"quick"};
  EXPECT_THAT(complaint(study), HasSubstr("\"quick\"; the cases are slow, fast"));
  study = small_study();
  study["cases"][1]["name"] = "slow";
  EXPECT_THAT(complaint(study), HasSubstr("two cases have the name \"slow\""));
  study = small_study();
  study["schemes"] = {"dual", "godunov"};
  EXPECT_THAT(complaint(study), HasSubstr("numerics.scheme"));
  study = small_study();
  study["cases"][0]["scene"]["impact"]["q"] = 3;
  EXPECT_THAT(complaint(study), HasSubstr("case slow: scene.impact.q = 3"));
  study = small_study();
  study["cases"][0]["name"] = "../slow";
  EXPECT_THAT(complaint(study), HasSubstr("case = \"../slow\": must be 1 to 64 letters"));
  study = small_study();
  study["cases"] = json::array();
  EXPECT_THAT(complaint(study), HasSubstr("must have 1 to 100 entries"));
  study = small_study();
  study.erase("ladder");
  EXPECT_THAT(complaint(study), HasSubstr("ladder"));
  study = small_study();
  study["ladder"][0]["seeds"] = 0;
  EXPECT_THAT(complaint(study), HasSubstr("seeds"));
}

TEST(Ensemble, HasMeanDeviationAndExtremes) {
  const statistics::Ensemble e = statistics::ensemble({1, 2, 6});
  EXPECT_EQ(e.runs, 3u);
  EXPECT_NEAR(e.mean, 3, 1e-12);
  EXPECT_NEAR(e.deviation, std::sqrt(7.0), 1e-12);  // (4 + 1 + 9)/2
  EXPECT_EQ(e.low, 1);
  EXPECT_EQ(e.high, 6);
  EXPECT_EQ(statistics::ensemble({5}).deviation, 0);
  EXPECT_EQ(statistics::ensemble({}).runs, 0u);
}

/// A result of `run` with one remnant.
ConvergenceResult result(const ConvergenceRun& run, double b_over_a) {
  ConvergenceResult r{run, {}, {{.rank = 1, .mass_over_total = 0.9, .b_over_a = b_over_a}}, 20};
  r.row.result.outcome_class = b_over_a < 0.3 ? "perfect-merging" : "hit-and-run";
  r.row.result.settled = true;
  return r;
}

TEST(ConvergenceCells, CollectSeedsOfOneSchemeCaseAndParticleNumber) {
  const ConvergenceStudy study = parse_convergence_study(small_study(), "study.json");
  std::vector<ConvergenceResult> results;
  for (const ConvergenceRun& run : runs_of(study))
    if (run.scheme == "dual" && run.case_name == "fast" && run.particles_per_target == 300)
      results.push_back(result(run, 0.2 + 0.05 * static_cast<double>(run.seed)));
  const auto cells = cells_of(study, results);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].b_over_a.runs, 4u);
  EXPECT_NEAR(cells[0].b_over_a.mean, 0.325, 1e-12);
  EXPECT_EQ(cells[0].period_h.runs, 0u);  // none spins
  EXPECT_NEAR(cells[0].p_top3_eer, 0.25, 1e-12);
  EXPECT_EQ(cells[0].classes, "hit-and-run 3; perfect-merging 1");
  EXPECT_THAT(cells_csv(cells), HasSubstr("dual,fast,300,4,0.325,"));
  EXPECT_THAT(runs_csv(results), HasSubstr("dual,fast,300,1,perfect-merging,1,"));

  const auto figure = figure_of(study, study.cases[1], cells);
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->panels[0].published, 0.27);
  ASSERT_EQ(figure->panels[0].series[0].size(), 1u);
  EXPECT_NEAR(figure->panels[0].series[0][0].high, 0.4, 1e-12);
  EXPECT_FALSE(figure_of(study, study.cases[0], cells));
}

TEST(ConvergenceCells, CountAnElongatedRemnantThatIsNotTheLargestButNoFragment) {
  const ConvergenceStudy study = parse_convergence_study(small_study(), "study.json");
  const auto runs = runs_of(study);
  const auto p_eer_with = [&](double mass) {
    ConvergenceResult r = result(runs.front(), 0.6);
    r.remnants.push_back({.rank = 2, .mass_over_total = mass, .b_over_a = 0.25});
    return cells_of(study, {r}).at(0).p_top3_eer;
  };
  EXPECT_EQ(p_eer_with(0.12), 1);
  EXPECT_EQ(p_eer_with(0.003), 0);
}

TEST(PublishedTime, IsLookedUpInRunsThatWentOnAndIsTheEndOfOthers) {
  const test::TemporaryFolder folder;
  json document = small_study();
  document["published_at_s"] = 1000;
  const ConvergenceStudy study = parse_convergence_study(document, "study.json");
  std::vector<ConvergenceResult> results(3, result(runs_of(study).front(), 0.6));
  for (std::size_t k = 0; k < results.size(); ++k)
    results[k].row.hash = std::string(64, static_cast<char>('a' + k));
  results[0].row.result.ended_at_s = 1000;
  results[1].row.result.ended_at_s = 5000;
  results[2].row.result.ended_at_s = 5000;  // and has no directory
  const job_folder::JobFolder jobs{folder.path()};
  const job_folder::JobDirectory directory = jobs.of(results[1].row.hash);
  std::filesystem::create_directories(directory.path);
  job_folder::RowLog<ending::RemnantLook> looks(directory.remnants());
  looks.add({{.time_s = 500, .rank = 1, .mass_over_total = 0.9, .b_over_a = 0.1}});
  looks.add({{.time_s = 900,
              .rank = 1,
              .mass_over_total = 0.5,
              .b_over_a = 0.4,
              .c_over_a = 0.3,
              .turns_per_h = 0.125},
             {.time_s = 900, .rank = 2, .mass_over_total = 0.3, .b_over_a = 0.2}});
  looks.add({{.time_s = 4000, .rank = 1, .mass_over_total = 0.8, .b_over_a = 0.6}});

  look_up_published_time(study, results, jobs);
  ASSERT_EQ(results[0].at_published.size(), 1u);
  EXPECT_EQ(results[0].at_published[0].b_over_a, 0.6);
  ASSERT_EQ(results[1].at_published.size(), 2u);
  EXPECT_EQ(results[1].at_published[0].mass_over_total, 0.5);
  EXPECT_EQ(results[1].at_published[0].b_over_a, 0.4);
  EXPECT_EQ(results[1].at_published[0].c_over_a, 0.3);
  EXPECT_EQ(results[1].at_published[0].spin_period_h, 8);
  EXPECT_FALSE(results[1].at_published[1].spin_period_h);
  EXPECT_TRUE(results[2].at_published.empty());

  const ConvergenceCell cell = cells_of(study, results).at(0);
  EXPECT_EQ(cell.at_published.b_over_a.runs, 2u);  // of the third it is not known
  EXPECT_NEAR(cell.at_published.b_over_a.mean, 0.5, 1e-12);
  EXPECT_NEAR(cell.at_published.m_1.mean, 0.7, 1e-12);
  EXPECT_EQ(cell.at_published.p_top3_eer, 0.5);  // the second remnant of the second run
  EXPECT_THAT(cells_csv({cell}), HasSubstr(",2,0.5,0.141,0.7,0.283,8,0,0.5\n"));
  const auto figure = figure_of(study, study.cases[0], {cell});
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->earlier, "at 1000 s");
  ASSERT_EQ(figure->panels[0].earlier[0].size(), 1u);
  EXPECT_NEAR(figure->panels[0].earlier[0][0].mean, 0.5, 1e-12);

  document["published_at_s"] = 600;  // what is known of another time does not count
  look_up_published_time(parse_convergence_study(document, "study.json"), results, jobs);
  ASSERT_EQ(results[1].at_published.size(), 1u);
  EXPECT_EQ(results[1].at_published[0].b_over_a, 0.1);
  EXPECT_TRUE(results[0].at_published.empty());
}

TEST(PublishedTime, IsNotLookedUpWhereTheStudyHasNone) {
  const ConvergenceStudy study = parse_convergence_study(small_study(), "study.json");
  std::vector<ConvergenceResult> results = {result(runs_of(study).front(), 0.6)};
  results[0].at_published = results[0].remnants;
  results[0].published_at_s = 1000;  // from a table of a study that has one
  look_up_published_time(study, results, {});
  EXPECT_TRUE(results[0].at_published.empty());
  const ConvergenceCell cell = cells_of(study, results).at(0);
  EXPECT_THAT(cells_csv({cell}), testing::EndsWith(",hit-and-run 1,0,,,,,,,\n"));
}

TEST(PublishedTime, MustComeAfterTheStart) {
  json study = small_study();
  study["published_at_s"] = 0;
  EXPECT_THAT(complaint(study), HasSubstr("published_at_s"));
}

TEST(ConvergenceDiagnosis, PutsHeatsOverTheKineticEnergyAtContactAndLooksAtOneTime) {
  const test::TemporaryFolder folder;
  const ConvergenceStudy study = parse_convergence_study(small_study(), "study.json");
  std::vector<ConvergenceResult> results;
  for (const ConvergenceRun& run : runs_of(study))
    if (run.scheme == "dual" && run.case_name == "fast" && run.seed == 1) {
      results.push_back(result(run, 0.2));
      results.back().row.hash = std::string(64, run.particles_per_target == 600 ? 'a' : 'b');
    }
  ASSERT_EQ(results.size(), 2u);
  const job_folder::JobFolder jobs{folder.path()};
  // Two bodies of 50 m and 2700 kg/m^3 at 24 cm/s: 2 x M/2 (v/2)^2.
  const double mass = 2700 * 4 / 3.0 * std::numbers::pi * 50 * 50 * 50;
  const double kinetic = mass * 0.12 * 0.12;
  job_folder::HistoryRow early, middle, end;
  early.time_s = 400, early.shear_energy_J = 0.02 * kinetic;
  middle.time_s = 1100, middle.eos_pressure_Pa = 3, middle.viscous_pressure_Pa = 6;
  middle.pressureless = 0.5, middle.density_kg_per_m3 = 2600;
  middle.summed_density_kg_per_m3 = 2500, middle.density_error = 0.125;
  end.time_s = 3000, end.dL_over_L = 1e-4, end.internal_energy_J = 1;
  end.viscous_heat_J = 0.75 * kinetic, end.friction_heat_J = 0.25 * kinetic;
  const job_folder::JobDirectory directory = jobs.of(std::string(64, 'a'));
  std::filesystem::create_directories(directory.path);
  job_folder::History(directory.history()).add({early, middle, end});
  // Of the run of most particles alone, and nothing where there is no history.
  EXPECT_THAT(diagnosis_csv(study, results, jobs),
              testing::EndsWith("\ndual,fast,600,0.75,0.25,0.02,1100,3,6,0.5,2600,2500,0.125,"
                                "0.0001\n"));
  EXPECT_THAT(diagnosis_csv(study, results, job_folder::JobFolder{folder / "nowhere"}),
              testing::EndsWith("dL_over_L_at_end\n"));
}

}  // namespace
}  // namespace eerie::studies
