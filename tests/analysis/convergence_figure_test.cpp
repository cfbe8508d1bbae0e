#include "analysis/convergence_figure.hpp"

#include <gmock/gmock.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie {
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
  const std::string script = convergence_script(small_figure());
  EXPECT_THAT(script, HasSubstr(" 0.3 0.02 0.27 0.33\n"));
  EXPECT_THAT(script, HasSubstr(" 0.25 0 0.25 0.25\n"));
  EXPECT_THAT(script, HasSubstr("plot 0.24 with lines"));
  EXPECT_THAT(script, HasSubstr("title 'published'"));
  EXPECT_THAT(script, HasSubstr("title 'one'"));
  EXPECT_THAT(script, Not(HasSubstr("title 'other'"))) << "it has no points";
}

}  // namespace
}  // namespace eerie
