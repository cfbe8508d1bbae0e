// Draws what eerie_settled found: how much of the time to 1e5 s the settled stop saves, and what
// b/a did after it. Usage: eerie_settled_figure DEFAULT.csv SURVEY.csv OUT.svg

#include <fmt/format.h>

#include <filesystem>

#include "analysis/drawing/gnuplot.hpp"
#include "tests/bench/csv_block.hpp"

namespace eerie {
namespace {

/// Okabe & Ito's blue and vermilion; the marks differ as well.
constexpr drawing::Colour strict_colour{0x00, 0x72, 0xb2}, survey_colour{0xd5, 0x5e, 0x00};

drawing::Script script(const std::filesystem::path& strict, const std::filesystem::path& survey) {
  return bench::data_block("$strict", strict) + bench::data_block("$survey", survey) +
         drawing::script(R"(set encoding utf8
set border lw 0.5
set tics scale 0.5 font ',7'
set xlabel font ',8'
set ylabel font ',8'
set key font ',7' samplen 1.5 Left reverse
set format y '%g'
saved(stop, end) = stop < 0 ? 0 : 100 * (1 - stop / end)
set xrange [0:100]
set xlabel 'time saved (% of 100,000 s)' offset 0,0.5
set multiplot layout 1,2
stats $strict using 7 nooutput
runs = STATS_records
set yrange [0:100]
set ylabel 'impacts that save so much or less (%)' offset 1,0
set key top left
plot $strict using (saved($7, $8)):(100. / runs) smooth cumulative with steps lw 1.5 lc rgb '{0}' title 'default tolerances', \
  $survey using (saved($7, $8)):(100. / runs) smooth cumulative with steps lw 1.5 lc rgb '{1}' title 'survey'
set yrange [-0.02:0.02]
set format y '%.3f'
set ylabel 'b/a at 100,000 s less at the stop' offset 1.5,0
set key bottom left
plot 0.01 lw 0.5 dt 3 lc rgb '#777777' notitle, -0.01 lw 0.5 dt 3 lc rgb '#777777' notitle, \
  $strict using (saved($7, $8)):($7 < 0 ? NaN : $12 - $11) with points pt 7 ps 0.45 lc rgb '{0}' title 'default tolerances', \
  $survey using (saved($7, $8)):($7 < 0 ? NaN : $12 - $11) with points pt 8 ps 0.6 lc rgb '{1}' title 'survey'
unset multiplot
)",
                         strict_colour, survey_colour);
}

}  // namespace
}  // namespace eerie

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: eerie_settled_figure DEFAULT.csv SURVEY.csv OUT.svg\n");
    return 2;
  }
  eerie::drawing::run_gnuplot(
      eerie::drawing::gnuplot_terminal(argv[3], 510, 190) + eerie::script(argv[1], argv[2]),
      argv[3]);
  return 0;
}
