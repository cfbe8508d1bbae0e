#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// A small impact with a snapshot every 500 s to 2,000 s in the folder "impact".
class PicturesOfAnImpact : public testing::Test {
 protected:
  void SetUp() override {
    install_text(folder / "scene.json", R"({"numerics": {"particles_per_target": 200},
      "output": {"snapshot_interval_s": 500}, "end": {"time_s": 2000}})");
    const Ended ended = eerie({"solve", "scene.json", "--out", "impact"});
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  test::TemporaryFolder folder;
};

TEST_F(PicturesOfAnImpact, PanelsSayWhichTimesTheyShow) {
  const Ended ended =
      eerie({"show", "impact", "--panels", "0,600,2e3", "-o", "new-panels.svg", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json report = json::parse(ended.out);
  ASSERT_EQ(report["panels"].size(), 3u);
  EXPECT_EQ(report["panels"][1]["requested_s"], 600);
  EXPECT_NEAR(report["panels"][1]["time_s"], 500, 30);  // the step that passed it
  EXPECT_THAT(report["panels"][1]["file"], HasSubstr("snapshot_0001.hdf5"));
  EXPECT_GT(report["frame_width_m"], 200);
  const std::string svg = read_file(folder / "new-panels.svg");
  EXPECT_THAT(svg, HasSubstr("impactor"));
  EXPECT_THAT(svg, HasSubstr("100 m"));
}

TEST_F(PicturesOfAnImpact, AreDrawnInEveryColourAndFormatWithTimesOfTheirOwn) {
  for (const char* colour : {"body", "depth", "speed"}) {
    const Ended ended = eerie({"show", "impact", "-o", "panels.png", "--colour", colour, "--cut"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("snapshot_0000.hdf5"));
    EXPECT_THAT(ended.out, HasSubstr("m wide, about the centre of mass"));
    EXPECT_THAT(read_file(folder / "panels.png"), testing::StartsWith("\x89PNG"));
  }
}

TEST_F(PicturesOfAnImpact, WhatCannotBeDrawnIsRefusedWithTheMend) {
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"--panels", "0,9000", "-o", "a.svg"}, "there are 0, 5"},
      {{"--panels", "0,9000", "-o", "a.svg"}, "--set output.snapshot_interval_s="},
      {{"--panels", "soon", "-o", "a.svg"}, "--panels soon: must be times in s"},
      {{"--panels", "-5", "-o", "a.svg"}, "--panels -5"},
      {{"--panels", "0"}, "-o panels.svg"},
      {{"-o", "a.jpg"}, "a figure can be .png, .svg or .pdf"},
      {{"--movie", "a.avi"}, "a film can be .mp4 or .gif"},
      {{"-o", "a.svg", "--colour", "red"}, "--colour"},
      {{"-o", "a.svg", "--width", "0"}, "--width"},
      {{}, "of a folder only pictures are shown"},
  };
  for (auto [arguments, expected] : cases) {
    arguments.insert(arguments.begin(), {"show", "impact"});
    const Ended ended = eerie(arguments);
    EXPECT_EQ(ended.code, 2) << expected;
    EXPECT_THAT(ended.err, HasSubstr(expected));
    EXPECT_EQ(ended.out, "");
  }
  fs::remove(folder / "impact/snapshot_0000.hdf5");
  const Ended ended = eerie({"show", "impact", "-o", "a.svg", "--colour", "depth"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("has no snapshot_0000.hdf5"));
  EXPECT_FALSE(fs::exists(folder / "a.svg"));
}

TEST_F(PicturesOfAnImpact, MakeAFilmOfEverySnapshot) {
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "ffmpeg is not installed: apt-get install ffmpeg";
  const Ended ended = eerie({"show", "impact", "--movie", "film.mp4"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("5 frames"));
  EXPECT_GT(fs::file_size(folder / "film.mp4"), 5000u);
}

TEST_F(PicturesOfAnImpact, MissingToolsAreNamedWithTheirPackages) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  const Ended film = eerie({"show", "impact", "--movie", "film.mp4"});
  const Ended panels = eerie({"show", "impact", "-o", "a.svg"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(film.code, 3);
  EXPECT_THAT(film.err, HasSubstr("apt-get install ffmpeg"));
  EXPECT_EQ(panels.code, 3);
  EXPECT_THAT(panels.err, HasSubstr("apt-get install gnuplot-nox"));
}

TEST(PicturesOfAJob, AreFoundByTheFirstDigitsOfItsHash) {
  const test::TemporaryFolder folder;
  test::write_sweep(folder.path(), 300, R"({"theta_imp_deg": [15]})");
  ASSERT_EQ(test::eerie(folder.path(), {"run", "sweep.json"}).code, 0);
  const std::string hash = test::job_directories(folder / "eerie.sqlite").at(0).filename();
  const Ended ended =
      test::eerie(folder.path(), {"show", hash.substr(0, 8), "-o", "a.svg", "--panels", "0,300"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("final.hdf5"));
}

}  // namespace
}  // namespace eerie
