#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/palette.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/analysis/diagrams/phase_diagram_fixture.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::diagrams {
namespace {

namespace fs = std::filesystem;
using test::small_map;
using testing::HasSubstr;
using testing::StartsWith;

bool on_path(const char* program) {
  std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
  for (std::size_t end; !path.empty(); path.erase(0, end == path.npos ? end : end + 1)) {
    end = path.find(':');
    if (fs::exists(fs::path(path.substr(0, end)) / program)) return true;
  }
  return false;
}

/// Drawing with the real gnuplot into a folder of its own.
class Gnuplot : public testing::Test {
 protected:
  void SetUp() override {
    if (!on_path("gnuplot")) GTEST_SKIP() << "gnuplot-nox is not installed";
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), {}));
  }
  test::TemporaryFolder folder_;
};

TEST_F(Gnuplot, DrawsTheFormatOfTheExtension) {
  draw_phase_diagram(folder_ / "map.png", small_map());
  draw_phase_diagram(folder_ / "map.svg", small_map());
  draw_phase_diagram(folder_ / "map.pdf", small_map());
  EXPECT_THAT(read_file(folder_ / "map.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(read_file(folder_ / "map.svg"), StartsWith("<?xml"));
  EXPECT_THAT(read_file(folder_ / "map.pdf"), StartsWith("%PDF"));
  EXPECT_EQ(files(), 3u);
}

TEST_F(Gnuplot, PngIsAsWideAsAColumnAt360DotsPerInch) {
  draw_phase_diagram(folder_ / "map.png", small_map());
  const std::string png = read_file(folder_ / "map.png");
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(png.at(i)); };
  EXPECT_EQ(byte(18) * 256 + byte(19), 1275);  // 255 points of 5 pixels
}

TEST_F(Gnuplot, SvgShowsValuesColoursAndAxes) {
  draw_phase_diagram(folder_ / "map.svg", small_map());
  const std::string svg = read_file(folder_ / "map.svg");
  for (const char* words : {">0.24<", ">0.47<", ">M<", ">22<", ">2.5<", "cm/s)", "deg)",
                            "of the largest remnant", "1,000 particles per target"})
    EXPECT_THAT(svg, HasSubstr(words));
  std::string packed = svg;  // "rgb( 73, 137, 199)"
  std::erase(packed, ' ');
  const drawing::Colour eer = drawing::b_over_a_colour(0.24);
  EXPECT_THAT(packed, HasSubstr(fmt::format("rgb({},{},{})", eer.r, eer.g, eer.b)));
}

TEST_F(Gnuplot, FileNamesAreOnlyNames) {
  for (const char* name : {"a'b\".png", "$(touch pwned).png", "`touch pwned`.png", "x; touch y.png",
                           "|cat.png", "-d.png", "ünï code.png"}) {
    draw_phase_diagram(folder_ / name, small_map());
    EXPECT_THAT(read_file(folder_ / name), StartsWith("\x89PNG")) << name;
  }
  EXPECT_EQ(files(), 7u);
}

TEST_F(Gnuplot, OneCellMakesAMap) {
  PhaseDiagram map = small_map();
  map.cells.resize(1);
  draw_phase_diagram(folder_ / "map.png", map);
  EXPECT_GT(fs::file_size(folder_ / "map.png"), 10000u);
}

TEST_F(Gnuplot, FaultyScriptIsAnErrorInItsOwnWordsAndKeepsTheOldFile) {
  install_text(folder_ / "map.svg", "old");
  try {
    drawing::run_gnuplot(drawing::Script("set terminal svg\nplot no_such_function(x)\n"),
                         folder_ / "map.svg");
    FAIL() << "it was drawn";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("undefined function: no_such_function"));
  }
  EXPECT_EQ(read_file(folder_ / "map.svg"), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(Gnuplot, MissingFolderIsAnErrorOfTheEnvironment) {
  EXPECT_THROW(draw_phase_diagram(folder_ / "no" / "map.png", small_map()), EnvironmentError);
}

TEST(GnuplotMissing, SaysWhatToInstall) {
  const test::TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  try {
    draw_phase_diagram(folder / "map.png", small_map());
    ADD_FAILURE() << "it was drawn";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("apt-get install gnuplot-nox"));
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace eerie::diagrams
