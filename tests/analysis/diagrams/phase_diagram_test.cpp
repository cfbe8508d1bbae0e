#include "analysis/diagrams/phase_diagram.hpp"

#include <gmock/gmock.h>

#include <set>

#include "analysis/diagrams/map_quantity.hpp"
#include "analysis/diagrams/phase_layout.hpp"
#include "analysis/diagrams/phase_script.hpp"
#include "analysis/drawing/palette.hpp"
#include "solver/base/error.hpp"
#include "tests/analysis/diagrams/phase_diagram_fixture.hpp"

namespace eerie::diagrams {
namespace {

using test::small_map;
using testing::HasSubstr;
using testing::Not;

/// The error of drawing a map that was changed for the worse; nothing may be written.
template <class Change>
std::string refusal(Change change) {
  PhaseDiagram map = small_map();
  change(map);
  try {
    draw_phase_diagram("/nonexistent/map.png", map);
  } catch (const InputError& error) {
    return error.what();
  }
  return "it was drawn";
}

TEST(PhaseDiagram, ImpossibleMapsAreRefusedWithTheCell) {
  EXPECT_THAT(refusal([](PhaseDiagram& m) { m.cells.clear(); }), HasSubstr("there is none"));
  EXPECT_THAT(refusal([](PhaseDiagram& m) { m.cells.push_back(m.cells[1]); }),
              HasSubstr("v_imp = 18 cm/s, theta_imp = 10 deg is there twice"));
  EXPECT_THAT(refusal([](PhaseDiagram& m) { m.cells[0].b_over_a = 1.2; }), HasSubstr("b/a = 1.2"));
  EXPECT_THAT(refusal([](PhaseDiagram& m) { m.cells[0].outcome = "bang"; }), HasSubstr("'bang'"));
  EXPECT_THAT(refusal([](PhaseDiagram& m) { m.cells[0].v_imp_cm_per_s = 0 / 0.0; }),
              HasSubstr("must be finite"));
}

TEST(PhaseDiagram, OtherExtensionsAreRefused) {
  EXPECT_THROW(draw_phase_diagram("/nonexistent/map.gif", small_map()), InputError);
  EXPECT_THROW(draw_phase_diagram("/nonexistent/map", small_map()), InputError);
}

std::string script(const PhaseDiagram& map, MapQuantity quantity = MapQuantity::b_over_a) {
  return phase_script({{map}, {quantity}}).commands.text();
}

std::size_t count(const std::string& text, const std::string& words) {
  std::size_t found = 0;
  for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++found;
  return found;
}

TEST(PhaseDiagram, BordersAreDrawnInPanelsOfTheirProbabilityAlone) {
  PhaseDiagram map = small_map();
  for (PhaseCell& cell : map.cells)
    if (cell.has_result()) cell.p_largest_eer = cell.v_imp_cm_per_s == 18 ? 0.25 : 1;
  EXPECT_THAT(script(map, MapQuantity::p_largest_eer), Not(HasSubstr("$half")));
  map.borders = EerBorders{{{{16, 11}, {17, 12.5}, {16, 11}}}, {{{15.5, 10}, {18, 13}}}};
  const std::string text = script(map, MapQuantity::p_largest_eer);
  EXPECT_THAT(text, HasSubstr("$half << EOD\n16 11\n17 12.5\n16 11\n\nEOD"));
  EXPECT_THAT(text, HasSubstr("$ends << EOD\n15.5 10\n18 13\n\nEOD"));
  EXPECT_THAT(text, HasSubstr("fitted: P = 1/2"));
  EXPECT_THAT(text, HasSubstr("its 68 % interval"));
  // Colours tell 0 and 1; letters would hide the curves.
  EXPECT_THAT(text, HasSubstr("\"0.25\""));
  EXPECT_THAT(text, Not(HasSubstr("\"1\" at")));
  EXPECT_THAT(text, Not(HasSubstr("perfect-merging")));
  EXPECT_THAT(script(map), Not(HasSubstr("$half")));
}

TEST(PhaseDiagram, EveryResultShowsColourValueAndClass) {
  const std::string text = script(small_map());
  for (const PhaseCell& cell : small_map().cells) {
    if (!cell.has_result() || !cell.b_over_a) continue;
    EXPECT_THAT(text, HasSubstr(drawing::hex(drawing::b_over_a_colour(*cell.b_over_a))));
    EXPECT_THAT(text, HasSubstr("\"" + std::to_string(*cell.b_over_a).substr(0, 4) + "\""));
  }
  for (const char* letter : {"\"M\"", "\"G\"", "\"H\"", "\"D\""})
    EXPECT_THAT(text, HasSubstr(letter));
}

TEST(PhaseDiagram, AResultWithoutTheNumberIsNotPaintedAsZero) {
  EXPECT_THAT(script(small_map()),
              Not(HasSubstr("fc rgb '" + drawing::hex(drawing::b_over_a_colour(0)) + "'")));
  EXPECT_THAT(script(small_map()), HasSubstr("\"–\""));
}

TEST(PhaseDiagram, LegendNamesOnlyWhatTheMapShows) {
  const std::string all = script(small_map());
  const auto optional = {"failed",     "not run yet", "unsettled", "a smaller remnant is an EER",
                         "v sin θ",    "stale",       "no job",    "has no such number",
                         "hit-and-run"};
  for (const char* words : optional) EXPECT_THAT(all, HasSubstr(words));
  EXPECT_THAT(all, HasSubstr("\"paper: v sin θ = 5.1 cm/s\""));
  EXPECT_THAT(all, Not(HasSubstr("erosion")));
  PhaseDiagram plain = small_map();
  plain.cells.resize(2);
  plain.cells[0].stale = false;
  plain.threshold_cm_per_s.reset();
  const std::string few = script(plain);
  for (const char* words : optional) EXPECT_THAT(few, Not(HasSubstr(words)));
}

/// What is drawn for the cells of a map, whatever the legend says.
std::string cells_of(const PhaseDiagram& map) {
  drawing::Canvas canvas(100, 100);
  draw_cells(canvas, CellGrid(map), {14, 17, 9, 12, {{0, 0}, {100, 100}}}, {});
  return canvas.commands().text();
}

TEST(PhaseDiagram, MissingPendingFailedUnsettledAndStaleImpactsLookDifferentFromOneAnother) {
  // The same map but for the place at 16 cm/s and 10 deg.
  PhaseDiagram map;
  const PhaseCell settled{16, 10, CellState::done, 0.5, "erosion"};
  map.cells = {settled, settled, settled};
  map.cells[0].v_imp_cm_per_s = 15, map.cells[1].theta_imp_deg = 11;
  map.cells[2].v_imp_cm_per_s = 15, map.cells[2].theta_imp_deg = 11;
  std::set<std::string> looks = {cells_of(map)};
  map.cells.push_back(settled);
  for (const CellState state :
       {CellState::pending, CellState::failed, CellState::unsettled, CellState::done}) {
    map.cells.back().state = state;
    looks.insert(cells_of(map));
  }
  map.cells.back().stale = true;
  looks.insert(cells_of(map));
  EXPECT_EQ(looks.size(), 6u);
}

TEST(PhaseDiagram, WordsThatHaveNoRoomAreLeftOut) {
  PhaseDiagram map = small_map();
  const std::string wide = script(map);
  for (int v = 30; v < 60; ++v) map.cells.push_back({v + 0.5, 10, CellState::pending});
  const std::string narrow = script(map);
  EXPECT_THAT(wide, HasSubstr("\"0.91\""));
  EXPECT_THAT(narrow, Not(HasSubstr("\"0.91\"")));
  EXPECT_THAT(narrow, HasSubstr(drawing::hex(drawing::b_over_a_colour(0.91))));
}

TEST(PhaseDiagram, ClassesHaveTheirColoursAndTheirShareWhereSeedsDiffer) {
  const std::string text = script(small_map(), MapQuantity::outcome);
  EXPECT_THAT(text, HasSubstr(drawing::hex(outcome_colour("hit-and-run"))));
  EXPECT_EQ(count(text, "\"75%\""), 1u);
  EXPECT_THAT(text, Not(HasSubstr("colorbox vertical")));
  PhaseDiagram sure = small_map();
  sure.cells[1].class_share = 1;
  EXPECT_THAT(script(sure, MapQuantity::outcome), Not(HasSubstr("%")));
}

TEST(PhaseDiagram, QuantitiesStandBesideTheirScale) {
  PhaseDiagram map = small_map();
  map.cells[0].period_h = 8, map.cells[1].period_h = 123;
  const std::string text = script(map, MapQuantity::period);
  EXPECT_THAT(text, HasSubstr("\"8.0\""));
  EXPECT_THAT(text, HasSubstr("\"123\""));
  EXPECT_THAT(text, HasSubstr("spin period, largest remnant (h)"));
  EXPECT_THAT(text, Not(HasSubstr("b/a")));
}

TEST(PhaseFigure, HasAPanelForEachPlaceWithOneScale) {
  PhaseDiagram other = small_map();
  other.phi_d_deg = 50, other.threshold_cm_per_s = 7.4;
  for (PhaseCell& cell : other.cells) cell.v_imp_cm_per_s += 2;
  const std::string text = phase_script({{small_map(), other}}).commands.text();
  EXPECT_EQ(count(text, "plot $none"), 2u);
  EXPECT_EQ(count(text, "set colorbox vertical"), 1u);
  EXPECT_EQ(count(text, "set xrange [13.5:26]"), 2u);
  EXPECT_THAT(text, HasSubstr("= 40°,  v sin θ = 5.1 cm/s\""));
  EXPECT_THAT(text, HasSubstr("= 50°,  v sin θ = 7.4 cm/s\""));
  EXPECT_THAT(text, HasSubstr("\"paper: v sin θ as in the panel"));
}

TEST(PhaseFigure, HasAPanelForEachQuantityWithItsOwnScale) {
  const std::string text =
      phase_script(
          {{small_map()}, {MapQuantity::b_over_a, MapQuantity::m_lr, MapQuantity::outcome}})
          .commands.text();
  EXPECT_EQ(count(text, "plot $none"), 3u);
  EXPECT_EQ(count(text, "set colorbox vertical"), 2u);
}

TEST(PhaseFigure, LettersStandOnceInThePanelOfClassesOrInTheFirst) {
  const std::string two =
      phase_script({{small_map()}, {MapQuantity::b_over_a, MapQuantity::m_lr}}).commands.text();
  const std::string one = script(small_map());
  EXPECT_EQ(count(two, "\"G\""), count(one, "\"G\""));
  const PhaseLayout page =
      phase_layout({{small_map()}, {MapQuantity::b_over_a, MapQuantity::outcome}}, 20);
  EXPECT_FALSE(page.panels[0].letters);
  EXPECT_TRUE(page.panels[1].letters);
}

TEST(PhaseFigure, GridsThatDifferHaveAxesOfTheirOwn) {
  PhaseDiagram other = small_map();
  EXPECT_FALSE(phase_layout({{small_map(), other}}, 20).own_axes);
  for (PhaseCell& cell : other.cells) cell.v_imp_cm_per_s += 30;
  const PhaseLayout page = phase_layout({{small_map(), other}}, 20);
  EXPECT_TRUE(page.own_axes);
  EXPECT_LT(page.panels[0].frame.v_high, page.panels[1].frame.v_low);
  for (const PhasePanel& panel : page.panels) EXPECT_TRUE(panel.labels_left && panel.labels_below);
}

TEST(PhaseFigure, ADiagramWithoutAnyResultIsNamedAndNotDrawn) {
  PhaseDiagram empty = small_map();
  empty.phi_d_deg = 50;
  for (PhaseCell& cell : empty.cells) cell = {cell.v_imp_cm_per_s, cell.theta_imp_deg};
  const std::string text = phase_script({{small_map(), empty}}).commands.text();
  EXPECT_EQ(count(text, "plot $none"), 1u);
  EXPECT_THAT(text, HasSubstr("= 50°: not run yet\""));
  EXPECT_EQ(count(phase_script({{empty}}).commands.text(), "plot $none"), 1u) << "alone it is";
}

TEST(PhaseFigure, TheLegendFillsAFreePlaceAmongThePanels) {
  const PhaseFigure five{{small_map()},
                         {MapQuantity::b_over_a, MapQuantity::c_over_a, MapQuantity::m_lr,
                          MapQuantity::period, MapQuantity::outcome}};
  const PhaseLayout page = phase_layout(five, 0);
  ASSERT_TRUE(page.gap);
  EXPECT_NEAR(phase_script(five).height_pt, page.height, 1e-9) << "no rows below the panels";
  EXPECT_FALSE(phase_layout({{small_map()}, {MapQuantity::b_over_a}}, 0).gap);
}

TEST(PhaseFigure, PanelsStandInThePageAndApart) {
  for (std::size_t n = 1; n <= most_panels; ++n) {
    const PhaseFigure figure{std::vector<PhaseDiagram>(n, small_map())};
    const PhaseLayout page = phase_layout(figure, 20);
    ASSERT_EQ(page.panels.size(), n);
    for (std::size_t a = 0; a < n; ++a) {
      const drawing::Area& area = page.panels[a].frame.area;
      EXPECT_GT(area.low.y, 20);
      EXPECT_LT(area.high.y, page.height);
      EXPECT_GT(area.low.x, 0);
      EXPECT_LT(area.high.x, page.width);
      EXPECT_GT(area.width(), 130);
      EXPECT_GT(area.height(), 100);
      for (std::size_t b = 0; b < a; ++b) {
        const drawing::Area& other = page.panels[b].frame.area;
        EXPECT_TRUE(other.high.x < area.low.x || area.high.y < other.low.y) << n << ": " << a;
      }
    }
  }
}

TEST(PhaseFigure, TooMuchForOnePictureIsRefused) {
  const auto refused = [](const PhaseFigure& figure) -> std::string {
    try {
      draw_phase_figure("/nonexistent/map.png", figure);
    } catch (const InputError& error) {
      return error.what();
    }
    return "it was drawn";
  };
  EXPECT_THAT(refused({{small_map(), small_map()}, {MapQuantity::b_over_a, MapQuantity::m_lr}}),
              HasSubstr("choose one quantity, or one mass ratio and friction angle"));
  EXPECT_THAT(refused({std::vector<PhaseDiagram>(most_panels + 1, small_map())}),
              HasSubstr("25 panels are too many for one figure, 24 are the most"));
  EXPECT_THAT(refused({}), HasSubstr("there is none"));
}

}  // namespace
}  // namespace eerie::diagrams
