#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/proof/column.hpp"
#include "tests/proof/record.hpp"

namespace eerie::proof {
namespace {

double exponent(const RunOut& a, const RunOut& b) {
  return std::log(b.tip / a.tip) / std::log(b.aspect / a.aspect);
}

TEST(GranularColumnLong, RunOutFollowsTheScalingLawsOfExperiments) {
  Record record("validation", 51, "Run-out of granular columns",
                "Columns of aspect ratio a = H0/L0 collapse in plane strain on a rough floor. "
                "phi_d is 27.2 deg: in plane strain mu_d is the sine of Mohr and Coulomb's angle, "
                "31 deg for Lube's sand. Run-out dL/L0 is that of what is two particles high, the "
                "least with a surface and an inside, and that of the furthest connected grain. "
                "Laws of experiments: 1.2 a and 1.9 a^(2/3) (Lube et al. 2005), 1.8 a and 2.3 "
                "a^(2/3) (Lajeunesse et al. 2005).");
  Curve tip{"furthest grain", {}, {}, "points pt 7 ps 0.6"},
      front{"two particles high", {}, {}, "points pt 6 ps 0.6"};
  std::vector<RunOut> runs;
  std::vector<std::vector<std::string>> rows;
  for (const auto& [aspect, across] :
       {std::pair{0.5, 44}, {1., 32}, {2., 24}, {3., 20}, {4.5, 15}, {6., 12}}) {
    const RunOut r = run_out(aspect, across);
    runs.push_back(r);
    tip.x.push_back(aspect), tip.y.push_back(r.tip);
    front.x.push_back(aspect), front.y.push_back(r.front);
    rows.push_back({fmt::format("{:g}", aspect), std::to_string(across),
                    fmt::format("{:.2f}", r.front), fmt::format("{:.2f}", r.tip),
                    fmt::format("{:.2f}", lube(aspect)), fmt::format("{:.2f}", lajeunesse(aspect)),
                    fmt::format("{:.0e}", r.kinetic_energy)});
    record.within(fmt::format("a = {:g}: two particles high, over Lube's law", aspect),
                  r.front / lube(aspect), 0.8, 1.3,
                  "his sand; plain Drucker-Prager friction is known to over-run experiments by 0.2 "
                  "to 0.3 (Jutzi 2015), and a front thinner than a particle is not there (0.2)");
    record.noted(fmt::format("a = {:g}: furthest grain over Lube's law", aspect),
                 r.tip / lube(aspect), "0.8 to 1.3",
                 "a layer of single grains bears no stress and slides on");
  }
  record.say(
      "Thin layers slide further than sand: with 56 particles over L0 a column of a = 1 "
      "is two particles high up to 1.20 of Lube's law, its furthest grain at 1.56.");
  record.table({"a", "particles over L0", "dL/L0 where two particles high", "dL/L0", "Lube",
                "Lajeunesse", "kinetic energy, M g H0"},
               rows);
  record.within("exponent from a = 0.5 to 2", exponent(runs[0], runs[2]), 0.8, 1.2,
                "1; two points known to a particle each (0.1 of the run-out)");
  record.within("exponent from a = 2 to 6", exponent(runs[2], runs[5]), 0.47, 0.87,
                "2/3; the same");
  Curve by_lube{"Lube et al. 2005", {}, {}, "lines lw 1"},
      by_lajeunesse{"Lajeunesse et al. 2005", {}, {}, "lines lw 1 dt 2"};
  for (double a = 0.4; a < 7; a *= 1.05) {
    by_lube.x.push_back(a), by_lube.y.push_back(lube(a));
    by_lajeunesse.x.push_back(a), by_lajeunesse.y.push_back(lajeunesse(a));
  }
  record.figure({"column",
                 "Run-out",
                 "a = H0/L0",
                 "dL/L0",
                 {tip, front, by_lube, by_lajeunesse},
                 "set logscale xy\nset xrange [0.4:7]\nset yrange [0.4:10]\n"
                 "set xtics (0.5, 1, 2, 3, 4.5, 6)\nset ytics (0.5, 1, 2, 4, 8)"});
}

}  // namespace
}  // namespace eerie::proof
