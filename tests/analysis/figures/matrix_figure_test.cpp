#include "analysis/figures/matrix_figure.hpp"

#include <gmock/gmock.h>

#include "analysis/drawing/palette.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::figures {
namespace {
using testing::HasSubstr;
using testing::Not;

MatrixFigure small_matrix() {
  return {{"A", "C25"},
          {{"", {{"default", {{{0.25, ".25  .95"}}, {{0.5, ".50  .49"}}}}}},
           {"kernel", {{"wendland-c2", {{{0.26, ".26  .96"}}, {}}}}}},
          "what stands here"};
}

TEST(MatrixFigure, ColoursEveryCellAsMapsDo) {
  const std::string script = matrix_script(small_matrix()).text();
  for (const double b_over_a : {0.25, 0.5, 0.26})
    EXPECT_THAT(script, HasSubstr(drawing::hex(drawing::b_over_a_colour(b_over_a))));
  EXPECT_THAT(script, HasSubstr(".50  .49"));
  EXPECT_THAT(script, HasSubstr("what stands here"));
  EXPECT_THAT(script, HasSubstr("wendland-c2"));
  EXPECT_THAT(script, Not(HasSubstr("inf")));
}

TEST(MatrixFigure, IsDrawnAndReplacesNothingWhenThereIsNothingToDraw) {
  const test::TemporaryFolder folder;
  draw_matrix(folder / "a.svg", small_matrix());
  EXPECT_THAT(read_file(folder / "a.svg"), HasSubstr(".25  .95"));
  draw_matrix(folder / "a.png", small_matrix());
  EXPECT_THAT(read_file(folder / "a.png"), testing::StartsWith("\x89PNG"));
  EXPECT_THROW(draw_matrix(folder / "b.svg", {{"A"}, {}, ""}), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.svg"));
}

}  // namespace
}  // namespace eerie::figures
