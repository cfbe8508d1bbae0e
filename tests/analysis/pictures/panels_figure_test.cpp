#include "analysis/pictures/panels_figure.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::pictures {
namespace {
using testing::HasSubstr;
using testing::Not;

/// `n` panels with `discs` spots each.
PanelsFigure figure(std::size_t n, ParticleColour colour, int discs = 30) {
  PanelsFigure f{{}, 500, {colour, 0.05, 0.07}};
  Random random(1, n);
  for (std::size_t k = 0; k < n; ++k) {
    const int pixels = panel_pixels(n);
    std::vector<Disc> spots;
    for (int i = 0; i < discs; ++i)
      spots.push_back({random.uniform() * pixels, random.uniform() * pixels, 4,
                       i % 2 == 0 ? target_colour : impactor_colour});
    f.panels.push_back({5000.4 * static_cast<double>(k), painted(spots, pixels, pixels), k});
  }
  return f;
}

TEST(PanelsFigure, IsDrawnInEveryFormatWithTimesScaleAndColours) {
  const test::TemporaryFolder folder;
  draw_panels(folder / "a.svg", figure(5, ParticleColour::body));
  const std::string svg = read_file(folder / "a.svg");
  for (const char* words : {"0 s", "5,000 s", "20,002 s", "200 m", "target", "impactor",
                            "1 remnant outside", "4 remnants outside", "data:image/png;base64"})
    EXPECT_THAT(svg, HasSubstr(words));
  draw_panels(folder / "a.png", figure(1, ParticleColour::speed));
  EXPECT_THAT(read_file(folder / "a.png"), testing::StartsWith("\x89PNG"));
  draw_panels(folder / "a.pdf", figure(3, ParticleColour::depth));
  EXPECT_THAT(read_file(folder / "a.pdf"), testing::StartsWith("%PDF"));
  EXPECT_THROW(draw_panels(folder / "a.jpg", figure(1, ParticleColour::body)), InputError);
  EXPECT_THROW(draw_panels(folder / "a.png", figure(0, ParticleColour::body)), InputError);
}

TEST(PanelsFigure, QuantitiesHaveAColourBarWithTheirUnit) {
  const std::string speed = panels_script(figure(5, ParticleColour::speed)).text();
  EXPECT_THAT(speed, HasSubstr("speed in own clump (cm/s)"));
  EXPECT_THAT(speed, HasSubstr("\"≥ 5\""));  // 0.05 m/s, and some are faster
  EXPECT_THAT(speed, Not(HasSubstr("impactor")));
  EXPECT_THAT(panels_script(figure(2, ParticleColour::depth)).text(),
              HasSubstr("initial depth (m)"));
}

TEST(PanelsFigure, UpToThreePanelsFitAColumnAndMoreAPage) {
  EXPECT_EQ(panel_pixels(3) / 5, (255 - 6 - 2 * 3) / 3);
  EXPECT_EQ(panel_pixels(5) / 5, (510 - 6 - 4 * 3) / 5);
  EXPECT_EQ(panel_pixels(8), panel_pixels(4));  // two rows of four
}

TEST(PanelsFigure, SizeOfTheFileDoesNotGrowWithTheNumberOfParticles) {
  const test::TemporaryFolder folder;
  draw_panels(folder / "few.svg", figure(5, ParticleColour::body, 3000));
  draw_panels(folder / "many.svg", figure(5, ParticleColour::body, 200'000));
  EXPECT_LT(std::filesystem::file_size(folder / "many.svg"), 4'000'000u);
  EXPECT_LT(std::filesystem::file_size(folder / "many.svg"),
            3 * std::filesystem::file_size(folder / "few.svg"));
}

}  // namespace
}  // namespace eerie::pictures
