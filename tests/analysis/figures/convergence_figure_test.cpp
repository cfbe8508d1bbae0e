#include "analysis/figures/convergence_figure.hpp"

#include <gmock/gmock.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::figures {
namespace {
using testing::HasSubstr;
using testing::Not;

ConvergenceFigure small_figure() {
  return {"A: small",
          {"one", "other"},
          {{"b/a", 0.24, {{{1000, 0.3, 0.02, 0.27, 0.33}, {5000, 0.25, 0, 0.25, 0.25}}, {}}},
           {"period (h)", {}, {{{1000, 9, 0, 9, 9}}, {}}}}};
}

TEST(ConvergenceFigure, IsDrawnAndReplacesNothingWhenThereIsNothingToDraw) {
  const test::TemporaryFolder folder;
  draw_convergence(folder / "a.svg", small_figure());
  EXPECT_THAT(read_file(folder / "a.svg"), HasSubstr("particles per target"));
  draw_convergence(folder / "a.png", small_figure());
  EXPECT_THAT(read_file(folder / "a.png"), testing::StartsWith("\x89PNG"));
  ConvergenceFigure empty = small_figure();
  for (ConvergencePanel& panel : empty.panels)
    for (auto& series : panel.series) series.clear();
  EXPECT_THROW(draw_convergence(folder / "b.svg", empty), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.svg"));
}

TEST(ConvergenceFigure, ShowsEveryPointWithItsBarsAndThePublishedNumberOnce) {
  const std::string script = convergence_script(small_figure()).text();
  EXPECT_THAT(script, HasSubstr(" 0.3 0.28 0.32\n"));
  EXPECT_THAT(script, HasSubstr(" 0.25 0.25 0.25\n"));
  EXPECT_THAT(script, HasSubstr("plot 0.24 with lines"));
  EXPECT_THAT(script, HasSubstr("set label \"published\""));
  EXPECT_THAT(script, HasSubstr("set label \"one\""));
  EXPECT_THAT(script, Not(HasSubstr("set label \"other\""))) << "it has no points";
}

TEST(ConvergenceFigure, ShowsWhatWasSeenEarlierAsOpenMarksWithinThePanel) {
  EXPECT_THAT(convergence_script(small_figure()).text(), Not(HasSubstr("pt 6")));
  ConvergenceFigure figure = small_figure();
  figure.panels[0].earlier = {{{1000, 0.9, 0, 0.9, 0.9}}, {}};
  figure.earlier = "at 100000 s";
  const std::string script = convergence_script(figure).text();
  EXPECT_THAT(script, HasSubstr("$p0s0e << EOD\n975 0.9\nEOD\n")) << "beside, as its series";
  EXPECT_THAT(script, HasSubstr("$p0s0e using 1:2 with points pt 6"));
  EXPECT_THAT(script, HasSubstr("set label \"at 100000 s\""));
  EXPECT_THAT(script, testing::ContainsRegex("set yrange \\[[0-9.]+:0\\.9[0-9]+\\]"));
  const test::TemporaryFolder folder;
  draw_convergence(folder / "a.svg", figure);
  EXPECT_THAT(read_file(folder / "a.svg"), HasSubstr("at 100000 s"));
}

}  // namespace
}  // namespace eerie::figures
