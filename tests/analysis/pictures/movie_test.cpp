#include "analysis/pictures/movie.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

#include "analysis/drawing/tool.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::pictures {
namespace {
using testing::HasSubstr;

bool has_ffmpeg() {
  try {
    drawing::require_tool({"ffmpeg", "", ""});
    return true;
  } catch (const EnvironmentError&) {
    return false;
  }
}

/// PATH without any program, as long as it lives.
class EmptyPath {
 public:
  EmptyPath() : path_(std::getenv("PATH")) { ::setenv("PATH", folder_.path().c_str(), 1); }
  ~EmptyPath() { ::setenv("PATH", path_.c_str(), 1); }
  EmptyPath(const EmptyPath&) = delete;
  EmptyPath& operator=(const EmptyPath&) = delete;

 private:
  test::TemporaryFolder folder_;
  std::string path_;
};

PanelsFigure frame(std::size_t k) {
  const int pixels = panel_pixels(1);
  const std::vector<Disc> discs = {
      {100.0 + 30 * static_cast<double>(k), pixels / 2.0, 40, target_colour}};
  return {{{1000.0 * static_cast<double>(k), painted(discs, pixels, pixels), 0}}, 300, {}};
}

TEST(Movie, OtherFormatsAreRefused) {
  EXPECT_THROW(require_movie("film.avi"), InputError);
  EXPECT_THROW(require_movie("film"), InputError);
}

TEST(Movie, WithoutFfmpegThePackageIsNamed) {
  const EmptyPath empty;
  const auto require = [] { require_movie("film.mp4"); };
  EXPECT_THAT(require, testing::ThrowsMessage<EnvironmentError>(
                           HasSubstr("ffmpeg is not installed and makes the films; install it: "
                                     "apt-get install ffmpeg")));
}

TEST(Movie, HasEveryFrame) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed: apt-get install ffmpeg";
  const test::TemporaryFolder folder;
  make_movie(folder / "film.mp4", 6, 10, frame);
  EXPECT_EQ(read_file(folder / "film.mp4").substr(4, 4), "ftyp");
  make_movie(folder / "film.gif", 6, 10, frame);
  EXPECT_THAT(read_file(folder / "film.gif"), testing::StartsWith("GIF89a"));
  // ffmpeg itself counts the frames.
  for (const char* name : {"film.mp4", "film.gif"}) {
    const drawing::ToolEnd end =
        drawing::run_tool({"ffmpeg", "", ""}, {"-nostdin", "-i", folder / name, "-f", "null", "-"});
    EXPECT_TRUE(end.well);
    EXPECT_THAT(end.words, HasSubstr("frame=    6")) << name;
  }
  EXPECT_THROW(make_movie(folder / "none.mp4", 0, 10, frame), InputError);
}

}  // namespace
}  // namespace eerie::pictures
