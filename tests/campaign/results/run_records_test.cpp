#include "campaign/results/run_records.hpp"

#include <gmock/gmock.h>

#include "campaign/studies/convergence_results.hpp"
#include "campaign/studies/cost_errors.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::results {
namespace {
using testing::HasSubstr;
using testing::IsEmpty;

class Records : public testing::Test {
 protected:
  RunRecords read(const std::string& text) {
    install_text(folder / "runs.csv", text);
    return read_run_records({folder / "runs.csv"});
  }
  std::string complaint(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  test::TemporaryFolder folder;
  const std::string hash = std::string(63, 'a') + "1", other = std::string(64, 'b');
};

/// A pair of remnants, one of which does not spin.
template <class Result>
Result pair_of_remnants(const std::string& hash) {
  Result r;
  r.row.hash = hash;
  db::Result& x = r.row.result;
  x.outcome_class = "hit-and-run";
  x.settled = true, x.ended_at_s = 21500, x.end_reason = "settled";
  x.m_lr_over_m_total = 0.5, x.m_slr_over_m_total = 0.25, x.n_eer = 1, x.dL_over_L = 1e-4;
  x.particle_steps = 1.5e7, x.solver_version = "0.1.0";
  x.b_over_a = 0.25, x.c_over_a = 0.125, x.period_h = 9.5;
  r.remnants = {{.rank = 1,
                 .mass_over_total = 0.5,
                 .b_over_a = 0.25,
                 .c_over_a = 0.125,
                 .spin_period_h = 9.5},
                {.rank = 2, .mass_over_total = 0.25, .b_over_a = 0.75, .c_over_a = 0.5}};
  r.core_seconds = 12.5;
  return r;
}

TEST_F(Records, ComeBackFromTheTableOfAConvergenceStudy) {
  auto written = pair_of_remnants<studies::ConvergenceResult>(hash);
  written.at_published = written.remnants;
  written.at_published[0].b_over_a = 0.375;
  written.published_at_s = 1e5;
  const RunRecords records = read(studies::runs_csv({written}));
  ASSERT_TRUE(records.contains(hash));
  studies::ConvergenceResult again;
  again.row.hash = hash;
  again.row.result = records.at(hash).result;
  again.remnants = records.at(hash).remnants;
  again.core_seconds = records.at(hash).core_seconds;
  again.at_published = records.at(hash).at_published;
  again.published_at_s = records.at(hash).published_at_s;
  EXPECT_EQ(again.at_published.size(), 2u);
  EXPECT_EQ(studies::runs_csv({again}), studies::runs_csv({written}));
  EXPECT_EQ(again.remnants.size(), 2u);
  EXPECT_FALSE(again.remnants[1].spin_period_h);
}

TEST_F(Records, ComeBackFromTheTableOfAChart) {
  studies::CostStudy study;
  study.cases = {{"A", "a, \"quoted\"", {}}};
  study.settings = {{"knob", "1,000", {}}};
  const auto written = pair_of_remnants<studies::CostResult>(hash);
  const RunRecords records = read(studies::cost_runs_csv(study, {written}));
  studies::CostResult again;
  again.row.hash = hash;
  again.row.result = records.at(hash).result;
  again.remnants = records.at(hash).remnants;
  again.core_seconds = records.at(hash).core_seconds;
  EXPECT_EQ(studies::cost_runs_csv(study, {again}), studies::cost_runs_csv(study, {written}));
}

TEST_F(Records, OfARunWithoutRemnantsHaveNone) {
  auto nothing_left = pair_of_remnants<studies::ConvergenceResult>(hash);
  nothing_left.remnants.clear();
  EXPECT_THAT(read(studies::runs_csv({nothing_left})).at(hash).remnants, IsEmpty());
}

TEST_F(Records, TakeTheLastOfARunInSeveralTables) {
  install_text(folder / "first.csv",
               "hash,class,core_s\n" + hash + ",erosion,1\n" + other + ",erosion,2\n");
  install_text(folder / "second.csv", "hash,class,core_s\n" + hash + ",hit-and-run,3\n");
  const RunRecords records = read_run_records({folder / "first.csv", folder / "second.csv"});
  EXPECT_EQ(records.at(hash).result.outcome_class, "hit-and-run");
  EXPECT_EQ(records.at(other).core_seconds, 2);
}

TEST_F(Records, AreRefusedWithFileLineColumnAndValue) {
  EXPECT_THAT(complaint("hash,class,b_over_a_1,m_1_over_m_total\n" + hash + ",erosion,1.5,0.9\n"),
              HasSubstr("runs.csv, line 2: b_over_a_1 = \"1.5\": must be a number from 0 to 1"));
  EXPECT_THAT(complaint("hash,class,core_s\n" + hash + ",erosion,much\n"),
              HasSubstr("core_s = \"much\""));
  EXPECT_THAT(complaint("hash,class,core_s\n" + hash + ",erosion,nan\n"),
              HasSubstr("core_s = \"nan\""));
  EXPECT_THAT(complaint("hash,class\n" + hash.substr(0, 16) + ",erosion\n"),
              HasSubstr("64 hexadecimal digits"));
  EXPECT_THAT(complaint("hash,class\n" + hash + ",\n"), HasSubstr("class = \"\""));
  EXPECT_THAT(complaint("class,b_over_a_1\nerosion,0.5\n"), HasSubstr("hash = \"\""));
}

}  // namespace
}  // namespace eerie::results
