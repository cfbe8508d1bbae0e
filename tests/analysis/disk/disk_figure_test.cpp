#include "analysis/disk/disk_figure.hpp"

#include <gmock/gmock.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::disk {
namespace {
using testing::HasSubstr;
using testing::Not;

constexpr double au = astronomical_unit;

TEST(DiskFigure, IsDrawnInEveryFormatWithUnitsOnItsAxes) {
  const test::TemporaryFolder folder;
  const DiskFigure turbulence = turbulence_figure(DragLaw::published, {}, au, 100 * au);
  draw_disk(folder / "a.svg", turbulence);
  const std::string svg = read_file(folder / "a.svg");
  EXPECT_THAT(svg, HasSubstr("distance from the star r (AU)"));
  EXPECT_THAT(svg, HasSubstr("(no unit)"));
  EXPECT_THAT(svg, HasSubstr("40 cm/s, published drag"));
  draw_disk(folder / "b.svg", stirring_figure(DragLaw::published, {}, {}, au, 100 * au));
  EXPECT_THAT(read_file(folder / "b.svg"), HasSubstr("radius of large bodies R (km)"));
  draw_disk(folder / "a.png", turbulence);
  EXPECT_THAT(read_file(folder / "a.png"), testing::StartsWith("\x89PNG"));
  draw_disk(folder / "a.pdf", turbulence);
  EXPECT_THAT(read_file(folder / "a.pdf"), testing::StartsWith("%PDF"));
  EXPECT_THROW(draw_disk(folder / "a.gif", turbulence), InputError);
}

TEST(DiskFigure, ShowsThePapersLimitsOnlyForThePapersBodies) {
  EXPECT_THAT(disk_script(turbulence_figure(DragLaw::published, {}, au, 100 * au)).text(),
              HasSubstr("in the paper\\047s text"));
  const Body smaller{50, 2700};
  const DiskFigure other = turbulence_figure(DragLaw::weidenschilling, smaller, au, 100 * au);
  EXPECT_EQ(other.laws.size(), 1u);
  EXPECT_THAT(disk_script(other).text(), Not(HasSubstr("in the paper\\047s text")));
  EXPECT_THROW(turbulence_figure(DragLaw::published, smaller, au, 100 * au), InputError);
  EXPECT_TRUE(
      stirring_figure(DragLaw::published, {}, {0.02, 2700}, au, 100 * au).published.empty());
}

TEST(DiskFigure, KeepsTheContoursThatMatterInItsFrame) {
  // Whole decades about 15 cm/s (1.4e-5 at 1 AU) and 40 cm/s (1.3e-2 at 100 AU).
  EXPECT_THAT(disk_script(turbulence_figure(DragLaw::published, {}, au, 100 * au)).text(),
              HasSubstr("set yrange [1e-05:0.1]"));
  EXPECT_THAT(disk_script(stirring_figure(DragLaw::published, {}, {}, au, 100 * au)).text(),
              HasSubstr("set yrange [0.1:100]"));
}

TEST(DiskFigure, DrawsTheLawAskedForSolidAndTheOtherDashed) {
  const std::string script =
      disk_script(turbulence_figure(DragLaw::weidenschilling, {}, au, 100 * au)).text();
  EXPECT_THAT(script, HasSubstr("\"40 cm/s, Weidenschilling\\047s drag\""));
  EXPECT_THAT(script, HasSubstr("\"dashed: published drag\""));
  EXPECT_THAT(script, HasSubstr("\"intermediate\""));
}

}  // namespace
}  // namespace eerie::disk
