#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/remnants/remnants.hpp"
#include "solver/base/file.hpp"
#include "solver/base/sha256.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// A first impact of small bodies, which merge; then another one with what they left.
class SecondImpact : public testing::Test {
 protected:
  void SetUp() override {
    const json scene = {{"impact", {{"separation", 1.3}, {"theta_imp_deg", 10}}},
                        {"numerics", {{"particles_per_target", 200}}},
                        {"end", {{"time_s", 3000}}}};
    install_text(folder / "first.json", scene.dump());
    ASSERT_EQ(eerie({"solve", "first.json", "--out", "first", "--quiet"}).code, 0);
    const Ended kept = eerie({"remnant", "first", "-o", "egg.hdf5", "--json"});
    ASSERT_EQ(kept.code, 0) << kept.err;
    report = json::parse(kept.out);
    second = report["scene"];
    second["impact"] = {{"q", 0.5}, {"separation", 3}, {"v_imp_cm_per_s", 15}};
    second["end"] = {{"time_s", 500}};
  }
  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  Ended solve(const json& scene, const std::string& out) {
    install_text(folder / "second.json", scene.dump());
    return eerie({"solve", "second.json", "--out", out, "--quiet"});
  }
  test::TemporaryFolder folder;
  json report, second;
};

TEST_F(SecondImpact, BeginsWithWhatTheFirstLeft) {
  ASSERT_EQ(solve(second, "second").code, 0);
  const io::Snapshot egg = io::read_snapshot(folder / "egg.hdf5");
  const io::Snapshot start = io::read_snapshot(folder / "second/snapshot_0000.hdf5");
  const auto found = remnants::find_remnants(start.state).remnants;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].particles, egg.state.size());
  EXPECT_NEAR(found[0].shape.b_over_a(), report["b_over_a"], 1e-6);
  const auto before = shapes::angular_velocity(egg.state.x, egg.state.v);
  ASSERT_TRUE(before && found[0].spin_period);
  EXPECT_NEAR(*found[0].spin_period * norm(*before), 2 * 3.14159265358979, 1e-5);
  EXPECT_TRUE(fs::exists(folder / "second/result.json"));
}

TEST_F(SecondImpact, IsRefusedARemnantOfTwoMaterials) {
  json first = json::parse(read_file(folder / "first.json"));
  first["impactor"] = {{"material", {{"phi_d_deg", 20}}}};
  install_text(folder / "two.json", first.dump());
  ASSERT_EQ(eerie({"solve", "two.json", "--out", "two", "--quiet"}).code, 0);
  const Ended refused = eerie({"remnant", "two", "-o", "two.hdf5"});
  EXPECT_NE(refused.code, 0);
  EXPECT_THAT(refused.err, HasSubstr("two materials"));
  EXPECT_FALSE(fs::exists(folder / "two.hdf5"));
}

TEST_F(SecondImpact, TurnsItAsTheSceneSays) {
  second["target"]["shape"]["turn_deg"] = 90;
  second["target"]["spin"] = {{"tilt_deg", 180}};
  ASSERT_EQ(solve(second, "second").code, 0);
  const auto found =
      remnants::find_remnants(io::read_snapshot(folder / "second/snapshot_0000.hdf5").state)
          .remnants;
  EXPECT_NEAR(std::abs(found.at(0).shape.axes[0].y), 1, 1e-6);
  EXPECT_NEAR(std::abs(found.at(0).shape.axes[2].z), 1, 1e-6);
}

TEST_F(SecondImpact, IsTheSameJobWhereverTheFileLies) {
  const Scene here = parse_scene(second);
  fs::copy_file(folder / "egg.hdf5", folder / "moved.hdf5");
  second["target"]["remnant"]["file"] = (folder / "moved.hdf5").string();
  EXPECT_EQ(scene_hash(here), scene_hash(parse_scene(second)));
  second["target"]["remnant"]["sha256"] = sha256_hex("another");
  EXPECT_NE(scene_hash(here), scene_hash(parse_scene(second)));
}

TEST_F(SecondImpact, RefusesWhatDoesNotFit) {
  int refused = 0;
  const auto refusal = [&](const json& change) {
    json scene = second;
    scene.merge_patch(change);
    const Ended ended = solve(scene, "refused-" + std::to_string(++refused));
    EXPECT_EQ(ended.code, 2) << change;
    EXPECT_FALSE(fs::exists(folder.path() / ("refused-" + std::to_string(refused)))) << change;
    return ended.err;
  };
  const auto target = [](const json& remnant) { return json{{"target", {{"remnant", remnant}}}}; };
  EXPECT_THAT(refusal({{"numerics", {{"particles_per_target", 1000}}}}), HasSubstr("; give "));
  EXPECT_THAT(refusal({{"target", {{"radius_m", 70}}}}), HasSubstr("target.radius_m"));
  EXPECT_THAT(refusal({{"target", {{"spin", {{"period_h", 5}}}}}}), HasSubstr("spins as it did"));
  EXPECT_THAT(refusal(target({{"file", ""}})), HasSubstr("go together"));
  EXPECT_THAT(refusal(target({{"file", (folder / "none.hdf5").string()}})), HasSubstr("none.hdf5"));
  EXPECT_THAT(refusal(target({{"sha256", sha256_hex("another")}})), HasSubstr("SHA-256"));
}

TEST_F(SecondImpact, OfASweepIsRefusedBeforeAnythingIsStored) {
  const auto commands = {std::vector<std::string>{"expand", "sweep.json"},
                         {"submit", "sweep.json"},
                         {"run", "sweep.json"}};
  const auto write = [&](const json& scene) {
    const json grid = {{"theta_imp_deg", {0, 10}}};
    install_text(folder / "sweep.json",
                 json{{"name", "again"}, {"scene", scene}, {"grid", grid}}.dump());
  };
  json other = second;
  other["numerics"]["particles_per_target"] = 1000;
  write(other);
  for (const auto& command : commands) {
    const Ended ended = eerie(command);
    EXPECT_EQ(ended.code, 2) << command[0];
    EXPECT_THAT(ended.err, HasSubstr("scene.numerics.particles_per_target = 1000"));
    EXPECT_FALSE(fs::exists(folder / "eerie.sqlite")) << command[0];
  }
  write(second);
  const Ended expanded = eerie({"expand", "sweep.json"});
  EXPECT_EQ(expanded.code, 0) << expanded.err;
  EXPECT_THAT(expanded.out, testing::Not(HasSubstr("Which settings?")))
      << "a remnant has the particles that it has";
}

TEST_F(SecondImpact, IsPreparedByACommandThatNamesItsMistakes) {
  EXPECT_THAT(eerie({"remnant", "first", "--remnant", "9", "-o", "a.hdf5"}).err,
              HasSubstr("--remnant 9"));
  EXPECT_THAT(eerie({"remnant", "first", "-o", "a.txt"}).err, HasSubstr("must end with .hdf5"));
  EXPECT_THAT(eerie({"remnant", "first", "-o", "egg.hdf5"}).out,
              HasSubstr("\"particles_per_target\""));
}

}  // namespace
}  // namespace eerie
