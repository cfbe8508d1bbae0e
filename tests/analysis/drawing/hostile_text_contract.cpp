#include <gmock/gmock.h>

#include <filesystem>
#include <functional>

#include "analysis/diagrams/phase_diagram.hpp"
#include "analysis/disk/disk_figure.hpp"
#include "analysis/drawing/tool.hpp"
#include "analysis/figures/accuracy_figure.hpp"
#include "analysis/figures/convergence_figure.hpp"
#include "analysis/figures/matrix_figure.hpp"
#include "analysis/figures/size_distribution.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/file.hpp"
#include "tests/analysis/diagrams/phase_diagram_fixture.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"

namespace eerie::drawing {
namespace {

namespace fs = std::filesystem;

/// A field of a figure that a text of somebody else's may stand in, with all else of it ordinary.
struct TextField {
  const char* name;
  std::function<void(const fs::path& path, const std::string& text)> draw;
};

figures::ConvergenceFigure convergence() {
  return {"title",
          {"one", "other"},
          {{"b/a", 0.24, {{{1000, 0.3, 0.02, 0.27, 0.33}, {5000, 0.25, 0, 0.25, 0.25}}, {}}},
           {"period", {}, {{{1000, 9, 0, 9, 9}}, {{1000, 8, 0, 8, 8}}}}}};
}

figures::AccuracyFigure accuracy() {
  const auto point = [](const char* label, double cost) {
    return figures::AccuracyPoint{label, cost, {{0.1, 0.01}, {0.2, 0.02}}, cost < 30, "name"};
  };
  return {{"b/a", "mass"},
          {{"default", true, {point("", 10)}}, {"knob", false, {point("a", 20), point("b", 40)}}},
          "title"};
}

figures::MatrixFigure matrix() {
  return {{"A", "B"},
          {{"group", {{"row", {{{0.25, ".25"}}, {{0.5, ".50"}}}}}}, {"", {{"alone", {{}, {}}}}}},
          "caption"};
}

disk::DiskFigure disk_figure() {
  constexpr double au = disk::astronomical_unit;
  return disk::turbulence_figure(disk::DragLaw::published, {}, au, 100 * au);
}

template <class Figure, class Draw, class Change>
TextField field(const char* name, Figure (*figure)(), Draw draw, Change change) {
  return {name, [=](const fs::path& path, const std::string& text) {
            Figure hostile = figure();
            change(hostile, text);
            draw(path, hostile);
          }};
}

/// Every text of every figure. Those that are not here have none: times, numbers and the program's
/// own words alone.
std::vector<TextField> fields() {
  using figures::AccuracyFigure, figures::ConvergenceFigure, figures::MatrixFigure;
  const auto c = figures::draw_convergence;
  const auto a = figures::draw_accuracy;
  const auto m = figures::draw_matrix;
  using T = const std::string&;
  return {
      field("convergence title", convergence, c, [](ConvergenceFigure& f, T t) { f.title = t; }),
      field("convergence series", convergence, c,
            [](ConvergenceFigure& f, T t) { f.series[0] = t; }),
      field("convergence axis", convergence, c,
            [](ConvergenceFigure& f, T t) { f.panels[1].label = t; }),
      field("convergence earlier", convergence, c,
            [](ConvergenceFigure& f, T t) { f.earlier = t; }),
      field("accuracy panel", accuracy, a, [](AccuracyFigure& f, T t) { f.panels[1] = t; }),
      field("accuracy series", accuracy, a, [](AccuracyFigure& f, T t) { f.series[1].name = t; }),
      field("accuracy point", accuracy, a,
            [](AccuracyFigure& f, T t) { f.series[1].points[0].name = t; }),
      field("accuracy title", accuracy, a, [](AccuracyFigure& f, T t) { f.title = t; }),
      field("matrix title", matrix, m, [](MatrixFigure& f, T t) { f.title = t; }),
      field("matrix note", matrix, m, [](MatrixFigure& f, T t) { f.notes = {std::string(t)}; }),
      field("matrix column", matrix, m, [](MatrixFigure& f, T t) { f.columns[1] = t; }),
      field("matrix group", matrix, m, [](MatrixFigure& f, T t) { f.groups[0].name = t; }),
      field("matrix row", matrix, m, [](MatrixFigure& f, T t) { f.groups[0].rows[0].label = t; }),
      field("matrix cell", matrix, m,
            [](MatrixFigure& f, T t) { f.groups[0].rows[0].cells[1]->text = t; }),
      field("matrix caption", matrix, m, [](MatrixFigure& f, T t) { f.caption = t; }),
      field("disk title", disk_figure, disk::draw_disk,
            [](disk::DiskFigure& f, T t) { f.title = t; }),
      field("disk axis", disk_figure, disk::draw_disk,
            [](disk::DiskFigure& f, T t) { f.y_label = t; }),
      {"sizes name",
       [](const fs::path& path, const std::string& text) {
         figures::draw_sizes(path, {{text, 1000, 2, 0.05, {0.9, 0.4, 0.4}}});
       }},
      {"map settings",
       [](const fs::path& path, const std::string& text) {
         diagrams::PhaseDiagram map = test::small_map();
         map.fidelity = text;
         diagrams::draw_phase_diagram(path, map);
       }},
  };
}

struct Hostile {
  std::string text, seen;
};

std::vector<Hostile> hostile_texts() {
  const auto same = [](std::string text) { return Hostile{text, text}; };
  const std::string long_one(5000, 'x');
  return {
      same("it's"),
      same("a \"word\" of two\" quotes"),
      same("`touch PWNED`"),
      same("$(touch PWNED) ${HOME} $0 #comment"),
      same("x' at 0,0; system('touch PWNED'); set label 'y"),
      same("x\" at 0,0; system(\"touch PWNED\"); set label \"y"),
      same("x\\\" at 0,0; system(\"touch PWNED\") #"),
      {"x' at 0,0\nsystem('touch PWNED')\n", "x' at 0,0\\nsystem('touch PWNED')\\n"},
      {"x\" at 0,0\nsystem(\"touch PWNED\")\n", "x\" at 0,0\\nsystem(\"touch PWNED\")\\n"},
      {"\n!touch PWNED\n", "\\n!touch PWNED\\n"},
      {"EOD\nsystem('touch PWNED')\n$p0s0 << EOD\n",
       "EOD\\nsystem('touch PWNED')\\n$p0s0 << EOD\\n"},
      {"\rset output 'PWNED'\r", "\\x0dset output 'PWNED'\\x0d"},
      same("_ ^ @ { } ~ & \\ a_b c^d e@f {g} {h ~i{.8-} j&{k} }{ \\_ \\{ \\\\"),
      same("v_{imp} x^{2} @GPVAL_PWD {/=40 big} {/Symbol a} {/:Bold b}"),
      same("back\\slash \\042 \\x22 \\U+0022 \\n and \\"),
      same("% %d %s %% %n $1 \"2 '3 `4 \\5"),
      same("]> ] ]> \\U+0041 \\U+1F600"),
      {"]]> ]]]>>", "]]\u200b> ]]]\u200b>>"},  // an XML file may not hold it
      same("</text><script>touch('PWNED')</script> &amp; <!-- --> ]]"),
      same("θ = 45°, 日本語, 😀, e\u0301"),
      {std::string("a\0b", 3), "a\\x00b"},
      {"\x1b[2J\x7f\u009b\u202e", "\\x1b[2J\\x7f\\x9b\\u202e"},
      {"\xff\xfe \xc3( \xed\xa0\x80 \xe2\x82",
       "\ufffd\ufffd \ufffd( \ufffd\ufffd\ufffd \ufffd\ufffd"},
      {long_one + "'\nsystem('touch PWNED')\n", long_one.substr(0, 200) + "…"},
  };
}

/// Draws into a folder of its own, which is the current one too: what runs there leaves its trace.
class HostileText : public testing::TestWithParam<TextField> {
 protected:
  void SetUp() override { fs::current_path(folder_.path()); }
  void TearDown() override { fs::current_path(before_); }

  /// The words of an SVG file, read by Python's XML.
  std::vector<std::string> texts_of(const fs::path& svg) const {
    const test::TemporaryFolder answers;
    const fs::path answer = answers / "texts";
    const fs::path reader = test::source_folder() / "tests/analysis/drawing/texts_of_svg.py";
    const ToolEnd end = run_tool({"/usr/bin/python3", "reads XML", "python3"},
                                 {reader.string(), svg.string()}, {}, answer);
    EXPECT_TRUE(end.well) << end.words;
    std::vector<std::string> texts;
    const std::string all = read_file(answer);
    for (std::size_t at = 0, next; (next = all.find('\0', at)) != std::string::npos; at = next + 1)
      texts.push_back(all.substr(at, next - at));
    return texts;
  }

  test::TemporaryFolder folder_;
  fs::path before_ = fs::current_path();
};

TEST_P(HostileText, IsShownLetterByLetterAndRunsNothing) {
  for (const Hostile& hostile : hostile_texts()) {
    ASSERT_NO_THROW(GetParam().draw(folder_ / "figure.svg", hostile.text)) << hostile.seen;
    EXPECT_THAT(texts_of(folder_ / "figure.svg"),
                testing::Contains(testing::HasSubstr(hostile.seen)));
    const auto files = std::distance(fs::directory_iterator(folder_.path()), {});
    ASSERT_EQ(files, 1) << hostile.seen << " left more than the figure";
  }
}

INSTANTIATE_TEST_SUITE_P(EveryField, HostileText, testing::ValuesIn(fields()), [](const auto& one) {
  std::string name = one.param.name;
  std::ranges::replace(name, ' ', '_');
  return name;
});

}  // namespace
}  // namespace eerie::drawing
