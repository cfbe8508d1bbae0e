#include "analysis/phase_diagram.hpp"

#include <gmock/gmock.h>

#include "analysis/palette.hpp"
#include "analysis/phase_script.hpp"
#include "solver/base/error.hpp"
#include "tests/analysis/phase_diagram_fixture.hpp"

namespace eerie {
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

TEST(PhaseDiagram, EveryResultShowsColourValueAndClass) {
  const std::string script = phase_script(small_map()).commands;
  for (const PhaseCell& cell : small_map().cells) {
    if (cell.outcome.empty()) continue;
    EXPECT_THAT(script, HasSubstr(hex(b_over_a_colour(cell.b_over_a))));
    EXPECT_THAT(script, HasSubstr("\"" + std::to_string(cell.b_over_a).substr(0, 4) + "\""));
  }
  for (const char* letter : {"\"M\"", "\"M?\"", "\"G\"", "\"H\"", "\"D\""})
    EXPECT_THAT(script, HasSubstr(letter));
}

TEST(PhaseDiagram, LegendNamesOnlyWhatTheMapShows) {
  const std::string all = phase_script(small_map()).commands;
  for (const char* words : {"failed", "not run yet", "unsettled", "a smaller remnant is an EER",
                            "v sin θ = 5.1 cm/s", "hit-and-run"})
    EXPECT_THAT(all, HasSubstr(words));
  EXPECT_THAT(all, Not(HasSubstr("erosion")));
  PhaseDiagram plain = small_map();
  plain.cells.resize(2);
  plain.threshold_cm_per_s.reset();
  const std::string few = phase_script(plain).commands;
  for (const char* words : {"failed", "not run yet", "unsettled", "a smaller remnant", "v sin θ"})
    EXPECT_THAT(few, Not(HasSubstr(words)));
}

TEST(PhaseDiagram, CsvHasOneSortedLinePerCellWithUnits) {
  EXPECT_EQ(phase_diagram_csv(small_map()),
            "q,phi_d_deg,particles_per_target,v_imp_cm_per_s,theta_imp_deg,v_imp_over_v_esc,state,"
            "outcome,b_over_a,eer\n"
            "1,40,1000,15,10,2.4430,done,perfect-merging,0.9100,0\n"
            "1,40,1000,18,10,2.9316,done,graze-and-merge,0.4700,0\n"
            "1,40,1000,22,10,3.5831,done,perfect-merging,0.2400,1\n"
            "1,40,1000,15,15,2.4430,unsettled,perfect-merging,0.6300,0\n"
            "1,40,1000,18,15,2.9316,failed,,,\n"
            "1,40,1000,22,15,3.5831,pending,,,\n"
            "1,40,1000,15,20,2.4430,done,hit-and-run,0.8200,1\n"
            "1,40,1000,18,20,2.9316,done,catastrophic-disruption,0.5800,0\n");
}

}  // namespace
}  // namespace eerie
