#include "campaign/job_folder/result_file.hpp"

#include <gmock/gmock.h>

#include "tests/campaign/job_folder/job_files.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::job_folder {
namespace {
using nlohmann::json;

class ResultFile : public testing::Test {
 protected:
  void SetUp() override { test::install_result(directory, scene); }
  test::TemporaryFolder folder;
  JobDirectory directory{folder.path()};
  Scene scene = parse_scene(json::object());
  std::string hash = scene_hash(scene);
};

TEST_F(ResultFile, GivesBackWhatTheRunAndItsAnalysisSaid) {
  const auto stored = read_result(directory, hash);
  ASSERT_TRUE(stored);
  const db::Result& r = stored->result;
  EXPECT_EQ(r.outcome_class, "perfect-merging");
  EXPECT_EQ(r.m_lr_over_m_total, 0.97);
  EXPECT_DOUBLE_EQ(r.b_over_a.value(), 0.24);
  EXPECT_DOUBLE_EQ(r.c_over_a.value(), 0.2);
  EXPECT_DOUBLE_EQ(r.period_h.value(), 9.36);
  EXPECT_TRUE(r.eer);
  EXPECT_EQ(r.n_eer, 1);
  EXPECT_EQ(r.n_remnants, 2);
  EXPECT_FALSE(r.settled);
  EXPECT_EQ(r.unsettled_reason, "remnants 1 and 2 meet again in 2.1 h");
  EXPECT_NEAR(r.dL_over_L.value(), 1e-4, 1e-9);
  EXPECT_EQ(r.steps, 1000);
  EXPECT_EQ(r.particle_steps, 2e6);
  EXPECT_EQ(r.threads, 2);
  EXPECT_FALSE(r.solver_version.empty());
  ASSERT_EQ(stored->remnants.size(), 2u);
  EXPECT_EQ(stored->remnants[0].mass_kg, 2.7e9);
  EXPECT_EQ(stored->remnants[0].z_m, 3);
  EXPECT_EQ(stored->remnants[1].spin_period_h, std::nullopt);
}

TEST_F(ResultFile, OfAnotherSceneIsNoResult) {
  EXPECT_FALSE(read_result(directory, scene_hash(parse_scene({{"numerics", {{"seed", 2}}}}))));
}

TEST_F(ResultFile, CutOffAnywhereIsNoResult) {
  const std::string whole = read_file(directory.result());
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    install_text(directory.result(), whole.substr(0, length));
    EXPECT_FALSE(read_result(directory, hash)) << "at " << length;
  }
}

TEST_F(ResultFile, WithoutAnyOneOfItsPartsIsNoResult) {
  const json whole = json::parse(read_file(directory.result()));
  for (const auto& [part, ignored] : whole.items()) {
    json rest = whole;
    rest.erase(part);
    install_text(directory.result(), rest.dump());
    EXPECT_FALSE(read_result(directory, hash)) << part;
  }
}

TEST_F(ResultFile, ThatIsAnotherKindOfJsonIsNoResult) {
  for (const char* text :
       {"null", "[]", "3", "{}", R"({"version": 1})", R"({"version": "1", "scene_hash": 3})"}) {
    install_text(directory.result(), text);
    EXPECT_FALSE(read_result(directory, hash)) << text;
  }
}

TEST_F(ResultFile, HasNoDriftToTellForAHeadOnImpact) {
  run::RunSummary summary = test::sample_summary(scene);
  summary.first_totals.angular_momentum = {0, 0, 1e-3};
  EXPECT_FALSE(angular_momentum_drift(scene, summary.first_totals, summary.last_totals));
  EXPECT_TRUE(run_json(scene, summary).at("dL_over_L").is_null());
}

TEST_F(ResultFile, WarnsOfADriftOfTheAngularMomentumAboveOnePerCentAndOfNoSmallerOne) {
  run::RunSummary summary = test::sample_summary(scene);
  const double start = summary.first_totals.angular_momentum.z;
  summary.last_totals.angular_momentum = {0, 0, 1.0099 * start};
  EXPECT_TRUE(run_warnings(scene, summary).empty());
  EXPECT_FALSE(run_json(scene, summary).contains("warnings"));
  summary.last_totals.angular_momentum = {0, 0, 0.89 * start};
  ASSERT_EQ(run_warnings(scene, summary).size(), 1u);
  EXPECT_NE(run_warnings(scene, summary)[0].find("changed by 11 %"), std::string::npos);
  EXPECT_EQ(run_json(scene, summary).at("warnings").size(), 1u);
}

TEST_F(ResultFile, TellsWhereItsNumbersComeFrom) {
  const json source = json::parse(read_file(directory.result())).at("provenance");
  for (const char* key : {"version", "solver_version", "commit", "compiler", "flags", "host"})
    EXPECT_FALSE(source.at(key).get<std::string>().empty()) << key;
  EXPECT_EQ(source.at("seed"), 1);
}

}  // namespace
}  // namespace eerie::job_folder
