#include "analysis/paper/check.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "solver/base/constants.hpp"
#include "tests/analysis/paper/check_fixture.hpp"

namespace eerie::paper {
namespace {
using test::fact_named;
using test::run_with;
using test::runs_of;
using test::seeds_with;
using testing::HasSubstr;

FactCheck checked(const std::string& fact, const std::vector<ImpactRun>& runs) {
  return check(fact_named(fact), runs, "a.sqlite");
}

Agreement verdict(const std::string& fact, const std::vector<ImpactRun>& runs) {
  return checked(fact, runs).agreement;
}

constexpr auto agrees = Agreement::agrees, disagrees = Agreement::disagrees,
               undecided = Agreement::undecided, not_enough = Agreement::not_enough;

TEST(Check, SaysOfNoFactThatItIsDecidedWithoutRuns) {
  for (const Fact& fact : paper_facts()) {
    const FactCheck f = check(fact, {}, "a.sqlite");
    EXPECT_EQ(f.agreement, not_enough) << fact.name;
    EXPECT_THAT(f.to_run, HasSubstr("eerie run ")) << fact.name;
    EXPECT_THAT(f.to_run, HasSubstr("--db a.sqlite")) << fact.name;
    EXPECT_EQ(f.found, "") << fact.name;
  }
}

TEST(Check, TakesRunsOfAnotherImpactForNoFact) {
  std::vector<ImpactRun> runs = seeds_with({0.24, 0.24, 0.24});
  for (ImpactRun& run : runs) run.theta_imp_deg = 15.02;
  EXPECT_EQ(verdict("reference-b-over-a", runs), not_enough);
  for (ImpactRun& run : runs) run.theta_imp_deg = 15.005;
  EXPECT_EQ(verdict("reference-b-over-a", runs), agrees);
  for (ImpactRun& run : runs) run.phi_d_deg = 41;
  EXPECT_EQ(verdict("reference-b-over-a", runs), not_enough);
}

TEST(Check, ComparesANumberWithinToleranceAndSpread) {
  EXPECT_EQ(verdict("reference-b-over-a", seeds_with({0.25, 0.255, 0.26})), agrees);
  EXPECT_EQ(verdict("reference-b-over-a", seeds_with({0.24, 0.24})), not_enough);
  const FactCheck far = checked("reference-b-over-a", seeds_with({0.34, 0.35, 0.36, 0.35}));
  EXPECT_EQ(far.agreement, disagrees);
  EXPECT_EQ(far.difference, "+0.110 (+46 %)");
  EXPECT_EQ(far.to_run, "");
  EXPECT_EQ(far.runs, 4u);
  // As far out, but so is every other run: the paper's may have been one of them.
  const FactCheck wide = checked("reference-b-over-a", seeds_with({0.2, 0.5, 0.3, 0.4}));
  EXPECT_EQ(wide.agreement, undecided);
  EXPECT_THAT(wide.to_run, HasSubstr("\"numerics.seed\":[1,2,3,4,5,6,7,8]"));
  // The mean is right by chance: its error is twice the tolerance.
  EXPECT_EQ(verdict("reference-b-over-a", seeds_with({0.12, 0.36, 0.2, 0.28})), undecided);
  EXPECT_EQ(verdict("reference-period", seeds_with({0.2, 0.3, 0.4})), agrees);
}

TEST(Check, NeverMixesSettingsAndTakesTheFinestThatDecides) {
  std::vector<ImpactRun> runs = seeds_with({0.35, 0.35, 0.35, 0.24, 0.24, 0.24, 0.4, 0.4});
  for (std::size_t k = 3; k < 6; ++k) runs[k].settings = {5000, "dual", ""};
  for (std::size_t k = 6; k < 8; ++k) runs[k].settings = {50000, "paper", "paper"};
  const FactCheck f = checked("reference-b-over-a", runs);
  EXPECT_EQ(f.agreement, agrees);
  EXPECT_EQ(f.settings.particles_per_target, 5000);
  EXPECT_EQ(f.runs, 3u);
}

TEST(Check, BelievesThatAShapeLastsOnlyOfRunsThatLast) {
  std::vector<ImpactRun> runs = seeds_with({0.24, 0.24, 0.24});
  const FactCheck early = checked("reference-lasts", runs);
  EXPECT_EQ(early.agreement, not_enough);
  EXPECT_THAT(early.found, HasSubstr("0 of 3 runs last so long"));
  EXPECT_THAT(early.to_run, HasSubstr("--set end.time_s=100000"));
  for (ImpactRun& run : runs) run.ended_at_s = 1e5;
  runs[2].ended_at_s = 99999.9999999999;  // the sum of its steps
  EXPECT_EQ(verdict("reference-lasts", runs), agrees);
  for (ImpactRun& run : runs) run.remnants[0].eer = false;
  EXPECT_EQ(verdict("reference-lasts", runs), disagrees);
}

TEST(Check, ComparesStifferBodiesWithThePapersAndUsesThemForNothingElse) {
  std::vector<ImpactRun> runs = seeds_with({0.24, 0.25, 0.26, 0.25, 0.24, 0.26});
  EXPECT_EQ(verdict("reference-stiffness", runs), not_enough);
  for (std::size_t k = 3; k < 6; ++k) runs[k].stiffness = 10;
  EXPECT_EQ(verdict("reference-stiffness", runs), agrees);
  for (std::size_t k = 3; k < 6; ++k) runs[k].remnants[0].b_over_a = 0.5 + 0.01 * double(k);
  EXPECT_EQ(verdict("reference-stiffness", runs), disagrees);
  EXPECT_EQ(checked("reference-b-over-a", runs).runs, 3u);
}

TEST(Check, FindsNumbersOfASmallerElongatedRemnant) {
  std::vector<ImpactRun> runs = seeds_with({0.6, 0.6, 0.6});
  for (ImpactRun& run : runs) run.v_imp_cm_per_s = 24;
  EXPECT_EQ(verdict("phi40-third", runs), disagrees);
  // There are runs enough, and nothing to measure in them.
  EXPECT_EQ(verdict("phi40-third-mass", runs), undecided);
  EXPECT_EQ(checked("phi40-third-mass", runs).difference, "no run forms it");
  EXPECT_EQ(verdict("phi40-third-mass", {runs[0], runs[1]}), not_enough);
  for (ImpactRun& run : runs) {
    run.remnants.push_back({2, 0.2, 100, 60, 0.6, false});
    run.remnants.push_back({3, 0.12, 90, 24, 0.27, true});  // 0.24 target masses
  }
  EXPECT_EQ(verdict("phi40-third", runs), agrees);
  EXPECT_EQ(verdict("phi40-third-mass", runs), agrees);
  EXPECT_EQ(verdict("phi40-third-b-over-a", runs), agrees);
}

TEST(Check, AsksNoCoarseRunForSmallRemnants) {
  std::vector<ImpactRun> runs = seeds_with({0.6, 0.6, 0.6});
  for (ImpactRun& run : runs) run.v_imp_cm_per_s = 24, run.settings = {400, "sketch", "sketch"};
  const FactCheck f = checked("phi40-third", runs);
  EXPECT_EQ(f.agreement, not_enough);
  EXPECT_THAT(f.found, HasSubstr("needs 1000 per target"));
  EXPECT_THAT(f.to_run, HasSubstr("--fidelity survey"));
}

TEST(Check, BelievesThatThereIsNoneOnlyOfAWholeGrid) {
  std::vector<ImpactRun> runs =
      runs_of(fact_named("phi30-none"), [](const ImpactPoint&) { return run_with(0.5); });
  EXPECT_EQ(verdict("phi30-none", runs), agrees);
  ImpactRun missing = runs.back();
  runs.pop_back();
  const FactCheck f = checked("phi30-none", runs);
  EXPECT_EQ(f.agreement, not_enough);
  EXPECT_EQ(f.impacts, 39u);
  EXPECT_EQ(f.impacts_wanted, 40u);
  EXPECT_EQ(f.to_run, "eerie run sweeps/table2-phi30.json --db a.sqlite --fidelity survey");
  // One run to the contrary is not sure, three are.
  missing.remnants[0].eer = true;
  runs.push_back(missing);
  EXPECT_EQ(verdict("phi30-none", runs), undecided);
  runs.push_back(missing), runs.push_back(missing);
  const FactCheck against = checked("phi30-none", runs);
  EXPECT_EQ(against.agreement, disagrees);
  EXPECT_EQ(against.difference, "v = 35 cm/s, theta = 20 deg (3 of 3)");
  // And where most of an impact's seeds say no, the few do not count.
  for (int k = 0; k < 4; ++k) runs.push_back(missing), runs.back().remnants[0].eer = false;
  const FactCheck split = checked("phi30-none", runs);
  EXPECT_EQ(split.agreement, agrees);
  EXPECT_EQ(split.split, 1u);
}

/// A whole grid of surveys without an EER, and what is added at its last impact.
std::vector<ImpactRun> surveys_and(int added, const RunSettings& settings, double b_over_a) {
  std::vector<ImpactRun> runs =
      runs_of(fact_named("phi30-none"), [](const ImpactPoint&) { return run_with(0.5); });
  ImpactRun more = runs.back();
  more.settings = settings;
  more.remnants[0].b_over_a = b_over_a, more.remnants[0].eer = b_over_a < 0.3;
  runs.insert(runs.end(), static_cast<std::size_t>(added), more);
  return runs;
}
const RunSettings standard{5000, "standard", "standard"};

TEST(Check, TakesEachImpactOfAGridByItsFinestRuns) {
  const FactCheck f = checked("phi30-none", surveys_and(3, standard, 0.2));
  EXPECT_EQ(f.agreement, disagrees);
  EXPECT_EQ(f.settings.name, "survey");
  EXPECT_EQ(f.impacts, 40u);
  EXPECT_EQ(f.runs, 42u);
  EXPECT_EQ(f.finer, 1u);
  EXPECT_EQ(f.difference, "v = 35 cm/s, theta = 20 deg (3 of 3)");
  // One of each: the finer one counts, and more of its kind are asked for.
  const FactCheck one = checked("phi30-none", surveys_and(1, standard, 0.2));
  EXPECT_EQ(one.agreement, undecided);
  EXPECT_THAT(one.to_run, HasSubstr("--fidelity standard"));
  // The whole grid by finer runs needs no surveys.
  std::vector<ImpactRun> whole = surveys_and(0, standard, 0.5);
  for (ImpactRun run : surveys_and(0, standard, 0.5)) run.settings = standard, whole.push_back(run);
  EXPECT_EQ(checked("phi30-none", whole).settings.name, "standard");
  EXPECT_EQ(checked("phi30-none", whole).finer, 0u);
}

TEST(Check, LetsOneFinerRunOfAnImpactNotOutweighThreeCoarser) {
  std::vector<ImpactRun> runs = surveys_and(1, standard, 0.2);
  runs.insert(runs.end(), 2, runs[39]);
  EXPECT_EQ(verdict("phi30-none", runs), agrees);
}

TEST(Check, MixesNoRunsByAnotherSchemeOrOfStifferBodiesIntoAGrid) {
  EXPECT_EQ(verdict("phi30-none", surveys_and(3, {50000, "paper", "paper"}, 0.2)), agrees);
  EXPECT_EQ(verdict("phi30-none", surveys_and(3, {20000, "closing-voids", ""}, 0.2)), agrees);
  std::vector<ImpactRun> stiff = surveys_and(3, standard, 0.2);
  for (std::size_t k = 40; k < 43; ++k) stiff[k].stiffness = 10;
  EXPECT_EQ(verdict("phi30-none", stiff), agrees);
}

TEST(Check, HoldsElongatedRemnantsToTheirBounds) {
  const Fact& fact = fact_named("phi50-bounds");
  const auto map = [&](double v_top) {
    std::vector<ImpactRun> runs = runs_of(fact, [&](const ImpactPoint& p) {
      return run_with(p.theta_imp_deg == 15 && p.v_imp_cm_per_s <= v_top ? 0.2 : 0.5);
    });
    const std::vector<ImpactRun> once = runs;
    for (int k = 0; k < 2; ++k) runs.insert(runs.end(), once.begin(), once.end());
    return runs;
  };
  EXPECT_EQ(verdict("phi50-bounds", map(35)), agrees);
  EXPECT_EQ(verdict("phi50-bounds", map(37.5)), disagrees);
  EXPECT_EQ(verdict("phi50-bounds", map(0)), disagrees);  // none at all
}

TEST(Check, WantsEveryNamedPointElongatedAndNoOther) {
  const Fact& fact = fact_named("q05-three");
  const auto map = [&](double from, double to) {
    std::vector<ImpactRun> runs = runs_of(fact, [&](const ImpactPoint& p) {
      return run_with(
          p.theta_imp_deg == 20 && p.v_imp_cm_per_s >= from && p.v_imp_cm_per_s <= to ? 0.27 : 0.5);
    });
    const std::vector<ImpactRun> once = runs;
    for (int k = 0; k < 2; ++k) runs.insert(runs.end(), once.begin(), once.end());
    return runs;
  };
  EXPECT_EQ(verdict("q05-three", map(23, 27)), agrees);
  EXPECT_EQ(verdict("q05-three", map(23, 25)), disagrees);
  EXPECT_EQ(verdict("q05-three", map(23, 29)), disagrees);
}

/// The fine grid with EERs about v sin(theta) = constant, cm/s.
std::vector<ImpactRun> ridge_at(double constant) {
  return runs_of(fact_named("phi40-ridge"), [&](const ImpactPoint& p) {
    const double s = p.v_imp_cm_per_s * std::sin(radians(p.theta_imp_deg));
    return run_with(std::abs(s - constant) < 0.45 && p.v_imp_cm_per_s < 25 ? 0.25 : 0.5);
  });
}

TEST(Check, FitsTheRidgeOfTheFineGrid) {
  const FactCheck f = checked("phi40-ridge", ridge_at(5.1));
  EXPECT_EQ(f.agreement, agrees);
  EXPECT_NEAR(f.value.value(), 5.1, 0.15);
  EXPECT_LT(f.low.value(), f.value.value());
  EXPECT_EQ(f.impacts, 96u);
  EXPECT_EQ(verdict("phi40-ridge", ridge_at(3.9)), disagrees);
  // The whole grid and no ridge on it: no constant, and not what the paper has.
  const FactCheck none = checked("phi40-ridge", ridge_at(50));
  EXPECT_EQ(none.agreement, disagrees);
  EXPECT_EQ(none.value, std::nullopt);
  std::vector<ImpactRun> part = ridge_at(50);
  part.pop_back();
  EXPECT_EQ(verdict("phi40-ridge", part), not_enough);
}

TEST(Check, FitsTheRidgeOfTheWholeGridAndNotOfImpactsThatWereChosen) {
  std::vector<ImpactRun> whole;
  for (const ImpactRun& run : ridge_at(5.1)) whole.insert(whole.end(), 3, run);
  for (ImpactRun& run : whole) run.settings = standard;
  std::vector<ImpactRun> finer = ridge_at(3.9);
  std::erase_if(finer, [](const ImpactRun& run) { return run.v_imp_cm_per_s < 16; });
  for (ImpactRun& run : finer) run.settings = {20000, "fine", "fine"};
  ASSERT_NEAR(checked("phi40-ridge", finer).value.value(), 3.9, 0.2);

  // One run of each does not count against three.
  std::vector<ImpactRun> both = whole;
  both.insert(both.end(), finer.begin(), finer.end());
  const FactCheck f = checked("phi40-ridge", both);
  EXPECT_EQ(f.settings.name, "standard");
  EXPECT_EQ(f.value, checked("phi40-ridge", whole).value);
  EXPECT_EQ(f.finer, 0u);
}

TEST(Check, CountsClassesAlongTheRidge) {
  const auto map = [](const char* fast) {
    return runs_of(fact_named("phi40-fast"), [&](const ImpactPoint& p) {
      ImpactRun run = run_with(0.7);
      run.outcome = p.v_imp_cm_per_s >= 25 ? fast : "hit-and-run";
      return run;
    });
  };
  const FactCheck f = checked("phi40-fast", map("catastrophic-disruption"));
  EXPECT_EQ(f.agreement, agrees);
  // (25, 12.5) and 27 to 30 cm/s at 10 deg: within 10 % of 5.1 cm/s.
  EXPECT_EQ(f.impacts_wanted, 5u);
  EXPECT_EQ(verdict("phi40-fast", map("partial-accretion")), disagrees);
  EXPECT_EQ(verdict("phi40-oblique", map("catastrophic-disruption")), agrees);
}

TEST(Check, CountsSmallerElongatedRemnantsInTheirWindow) {
  const auto map = [](double v_top) {
    std::vector<ImpactRun> runs = runs_of(fact_named("phi50-smaller"), [&](const ImpactPoint& p) {
      ImpactRun run = run_with(0.7);
      if (p.theta_imp_deg == 25 && p.v_imp_cm_per_s >= 20 && p.v_imp_cm_per_s <= v_top)
        run.remnants.push_back({2, 0.1, 80, 20, 0.25, true});
      return run;
    });
    const std::vector<ImpactRun> once = runs;
    for (int k = 0; k < 2; ++k) runs.insert(runs.end(), once.begin(), once.end());
    return runs;
  };
  EXPECT_EQ(verdict("phi50-smaller", map(27.5)), agrees);
  EXPECT_EQ(checked("phi50-smaller", map(25)).difference, "3 instead of 4");
  EXPECT_EQ(verdict("phi50-smaller", map(32.5)), disagrees);
}

TEST(Check, SeesMergersAndAllClasses) {
  std::vector<ImpactRun> runs = runs_of(fact_named("phi40-merged"), [](const ImpactPoint& p) {
    return run_with(p.theta_imp_deg == 15 ? 0.2 : 0.5);
  });
  EXPECT_EQ(verdict("phi40-merged", runs), agrees);
  for (ImpactRun& run : runs) run.m_lr_over_m_total = 0.6;
  EXPECT_EQ(verdict("phi40-merged", runs), undecided);  // one run each
  runs = runs_of(fact_named("q025-classes"), [](const ImpactPoint& p) {
    ImpactRun run = run_with(0.7);
    if (p.theta_imp_deg > 20) run.outcome = "hit-and-run";
    return run;
  });
  EXPECT_EQ(verdict("q025-classes", runs), disagrees);
  runs.front().outcome = "catastrophic-disruption";
  EXPECT_EQ(verdict("q025-classes", runs), agrees);
}

TEST(Check, CountsUnsettledRunsAsTheyStandAndSaysHowMany) {
  std::vector<ImpactRun> runs = seeds_with({0.24, 0.24, 0.24});
  runs[1].settled = false;
  const FactCheck f = checked("reference-b-over-a", runs);
  EXPECT_EQ(f.agreement, agrees);
  EXPECT_EQ(f.unsettled, 1u);
}

}  // namespace
}  // namespace eerie::paper
