#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/analysis/remnants/bodies.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// A cigar that turns once in two hours about its shortest axis, and a small ball far away.
class LightCurveOfACigar : public testing::Test {
 protected:
  void SetUp() override {
    particles::State state = test::empty_state();
    const auto cigar = test::ellipsoid({100, 40, 30}, test::spacing);
    const double omega = 2 * 3.14159265358979 / 7200;
    test::add(state, cigar, test::spinning(cigar, {0, 0, omega}, {}), particles::Body::target);
    test::add_body(state, {25, 25, 25}, {1000, 0, 0}, {}, particles::Body::impactor);
    state.time = 3000;
    io::Snapshot snapshot = test::snapshot_of(state);
    // A particle's share of the material is a cell of the lattice.
    ASSERT_NEAR(snapshot.scene.material.rho0_kg_per_m3, 2700, 1e-9);
    fs::create_directory(folder / "run");
    io::write_snapshot(folder / "run/final.hdf5", snapshot);
  }
  Ended lightcurve(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "lightcurve");
    return test::eerie(folder.path(), arguments);
  }
  test::TemporaryFolder folder;
};

TEST_F(LightCurveOfACigar, HasTheAmplitudeOfItsAxesAndItsSpin) {
  const Ended ended = lightcurve({"run", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json report = json::parse(ended.out);
  EXPECT_NEAR(report["ellipsoid_mag"], 2.5 * std::log10(2.5), 0.02);
  // Six particles across the shortest axis: the outline is coarse.
  EXPECT_NEAR(report["particles_mag"], 2.5 * std::log10(2.5), 0.08);
  EXPECT_NEAR(report["remnant"]["spin_period_h"], 2, 1e-6);
  EXPECT_NEAR(report["remnant"]["spin_from_shortest_axis_deg"], 0, 1e-3);
  EXPECT_EQ(report["amplitude_over_aspect"].size(), 31u);
  EXPECT_EQ(report["amplitude_over_aspect"][30]["aspect_deg"], 90);
  EXPECT_EQ(report["amplitude_over_aspect"][30]["particles_mag"], report["particles_mag"]);
  EXPECT_TRUE(report["files"].empty());
}

TEST_F(LightCurveOfACigar, IsToldInWordsOfASnapshotToo) {
  const Ended ended = lightcurve({"run/final.hdf5", "--aspect", "30"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("turns in 2.00 h, 0.0 deg from its shortest axis"));
  EXPECT_THAT(ended.out, HasSubstr("amplitude at aspect 30 deg"));
  EXPECT_THAT(ended.out, HasSubstr("phase angle 0"));
  EXPECT_EQ(ended.err, "");
}

TEST_F(LightCurveOfACigar, WarnsWhereTheBodyTurnsAboutAnotherAxis) {
  particles::State state = test::empty_state();
  const auto cigar = test::ellipsoid({100, 40, 30}, test::spacing);
  test::add(state, cigar, test::spinning(cigar, {0, 1e-3, 0}, {}), particles::Body::target);
  io::write_snapshot(folder / "tumbling.hdf5", test::snapshot_of(state));
  const Ended ended = lightcurve({"tumbling.hdf5"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("90.0 deg from its shortest axis"));
  EXPECT_THAT(ended.err, HasSubstr("warning: it turns 90 deg from its shortest axis"));
}

TEST_F(LightCurveOfACigar, IsDrawnWithTablesBesideIt) {
  const Ended ended = lightcurve({"run", "-o", "new-cigar.svg", "--remnant", "2", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json report = json::parse(ended.out);
  EXPECT_EQ(report["remnant"]["rank"], 2);
  EXPECT_LT(report["particles_mag"], 0.2);
  EXPECT_EQ(report["files"].size(), 3u);
  EXPECT_THAT(read_file(folder / "new-cigar.svg"), HasSubstr("Oumuamua"));
  EXPECT_THAT(read_file(folder / "new-cigar.csv"), HasSubstr("rotation_phase_deg"));
  EXPECT_THAT(read_file(folder / "new-cigar-aspect.csv"), HasSubstr("\n90,"));
}

TEST_F(LightCurveOfACigar, WhatCannotBeSeenIsRefused) {
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"run", "--remnant", "3"}, "--remnant 3: run/final.hdf5 holds 2 remnants"},
      {{"run", "--remnant", "0"}, "--remnant"},
      {{"run", "--aspect", "91"}, "--aspect"},
      {{"run", "-o", "a.gif"}, "a figure can be .png, .svg or .pdf"},
      {{"none.hdf5"}, "there is no such snapshot"},
      {{"."}, "holds no snapshots"},
  };
  for (const auto& [arguments, expected] : cases) {
    const Ended ended = lightcurve(arguments);
    EXPECT_EQ(ended.code, 2) << expected;
    EXPECT_THAT(ended.err, HasSubstr(expected));
    EXPECT_EQ(ended.out, "");
  }
}

}  // namespace
}  // namespace eerie
