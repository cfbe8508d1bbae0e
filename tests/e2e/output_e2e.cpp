#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "campaign/text/layout.hpp"
#include "solver/base/file.hpp"
#include "tests/support/impact_database.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"
#include "tests/support/streams.hpp"

namespace eerie {
namespace {
using test::Ended;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

/// A folder in which every command has something to say. It is made once: the commands that are
/// tried change nothing that another one needs.
class EveryCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new test::TemporaryFolder;
    db::Connection connection(*folder / "impacts.sqlite", db::Access::write);
    for (int k = 0; k < 6; ++k)
      test::add_impact(connection, test::survey_scene(1, 40, 16 + k, 15, 1), 0.2 + 0.1 * k);
    test::write_sweep(folder->path(), 300, R"({"v_imp_cm_per_s": [15, 20]})");
    install_text(*folder / "scene.json",
                 R"({"numerics": {"particles_per_target": 200}, "end": {"time_s": 300}})");
    install_text(*folder / "converge.json", R"({
      "name": "tiny", "schemes": ["dual"], "scene": {"end": {"time_s": 300}},
      "cases": [{"name": "A", "scene": {}}],
      "ladder": [{"particles_per_target": 200, "seeds": 1}]})");
    install_text(*folder / "chart.json", R"({
      "name": "chart", "scene": {"end": {"time_s": 300}, "numerics": {"particles_per_target": 200}},
      "seeds": 1, "cases": [{"name": "A", "scene": {}}],
      "knobs": [{"name": "cfl", "settings": [{"label": "0.3", "set": {"numerics.cfl": 0.3}}]}],
      "reference": {"label": "finer", "seeds": 1, "set": {"numerics.particles_per_target": 300}}})");
    prepared = 0;
    for (const Words& words :
         {Words{"run", "sweep.json", "--db", "run.sqlite"},
          Words{"solve", "scene.json", "--out", "impact"},
          Words{"merge", "impacts.sqlite", "-o", "merged.sqlite"},
          Words{"merge", "run.sqlite", "-o", "extended.sqlite", "--copy"},
          Words{"catalogue", "export", "--db", "impacts.sqlite", "-o", "catalogue.csv"},
          Words{"converge", "converge.json", "-o", "converge", "--db", "studies.sqlite"},
          Words{"chart", "chart.json", "-o", "chart.svg", "--db", "studies.sqlite"}}) {
      const Ended ended = test::eerie(folder->path(), words);
      EXPECT_EQ(ended.code, 0) << words[0] << ": " << ended.err;
      if (ended.code == 0) ++prepared;
    }
    const Ended jobs = test::eerie(folder->path(), {"query", "--db", "run.sqlite", "--json"});
    job = nlohmann::json::parse(jobs.out).at(0).at("hash").get<std::string>().substr(0, 8);
  }
  static void TearDownTestSuite() { delete folder; }

  static std::vector<Words> commands() {
    const Words here = {"--db", "run.sqlite", "--all"};
    const auto change = [&](Words words) {
      words.insert(words.end(), here.begin(), here.end());
      return words;
    };
    return {{"run", "sweep.json", "--db", "run.sqlite"},
            {"expand", "sweep.json", "--list"},
            {"solve", "scene.json", "--out", "impact"},
            {"analyse", "impact/final.hdf5"},
            {"analyse", "--db", "run.sqlite"},
            {"daemon", "--db", "run.sqlite", "--until-idle"},
            {"submit", "sweep.json", "--db", "run.sqlite"},
            change({"pause"}),
            change({"resume"}),
            change({"cancel"}),
            change({"retry"}),
            change({"priority", "1"}),
            change({"wall-limit", "2h"}),
            {"status", "--db", "impacts.sqlite"},
            {"show", job, "--db", "run.sqlite"},
            {"lightcurve", "impact/final.hdf5"},
            {"remnant", "impact", "-o", "egg.hdf5"},
            {"log", job, "--db", "run.sqlite"},
            {"doctor", "--db", "run.sqlite"},
            {"merge", "merged.sqlite", "impacts.sqlite"},
            {"compare", "impacts.sqlite", "merged.sqlite"},
            {"extend", job, "--until", "600", "--db", "extended.sqlite"},
            {"query", "--db", "impacts.sqlite"},
            {"query", "--db", "impacts.sqlite", "--of", "remnants"},
            {"query", "--db", "impacts.sqlite", "--of", "maps", "--format", "csv"},
            {"catalogue", "export", "--db", "impacts.sqlite"},
            {"catalogue", "import", "catalogue.csv", "-o", "imported.json"},
            {"catalogue", "compare", "catalogue.csv", "--db", "impacts.sqlite"},
            {"sizes", "--db", "impacts.sqlite"},
            {"fidelities"},
            {"map", "--db", "impacts.sqlite", "-o", "map.csv"},
            {"threshold", "--db", "impacts.sqlite"},
            {"check", "--db", "impacts.sqlite"},
            {"odds", "--db", "impacts.sqlite"},
            {"converge", "converge.json", "-o", "converge", "--db", "studies.sqlite"},
            {"chart", "chart.json", "-o", "chart.svg", "--db", "studies.sqlite"},
            {"disk"},
            {"init", fmt::format("begun-{}", begun++)},  // which overwrites nothing
            {"help", "run"},
            {"manual", "run"},
            {"manual", "--completion", "zsh"},
            {"--help"},
            {"--version"}};
  }

  void SetUp() override { ASSERT_EQ(prepared, 7); }

  static inline test::TemporaryFolder* folder = nullptr;
  static inline std::string job;
  static inline int prepared = 0, begun = 0;
};

TEST_F(EveryCommand, OfTheHelpIsTriedHere) {
  std::set<std::string> tried;
  for (const Words& words : commands()) tried.insert(words[0]);
  tried.insert("serve");  // shows until it is told to stop: serve_e2e.cpp
  const Ended help = test::eerie(folder->path(), {"--help"});
  const std::regex name("^  ([a-z][a-z-]+)( |$)");
  std::size_t found = 0;
  for (const std::string& line : lines_of(help.out))
    if (std::smatch match; std::regex_search(line, match, name)) {
      ++found;
      EXPECT_TRUE(tried.contains(match[1])) << line;
    }
  EXPECT_GE(found, 25u);
}

TEST_F(EveryCommand, EndsWith3AndTheReasonWhereItsOutputCannotBeWritten) {
  for (const Words& words : commands()) {
    const Ended ended = test::on_full_disk(folder->path(), words);
    EXPECT_EQ(ended.code, 3) << words[0] << ": " << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("cannot write the output: No space left on device"))
        << words[0];
  }
}

TEST_F(EveryCommand, LeavesItToTheReaderToCloseThePipe) {
  for (const Words& words : commands()) {
    const Ended ended = test::into_closed_pipe(folder->path(), words);
    EXPECT_EQ(ended.code, 0) << words[0] << ": " << ended.err;
    EXPECT_THAT(ended.err, Not(HasSubstr("cannot write"))) << words[0];
  }
}

TEST_F(EveryCommand, EndsAsItWouldWhereNobodyReadsItsComplaints) {
  for (const Words& words : commands())
    EXPECT_EQ(test::complaining_to_nobody(folder->path(), words).code, 0) << words[0];
}

TEST_F(EveryCommand, PutsTablesIntoTheColumnsOfTheTerminal) {
  // Of sentences the terminal breaks the lines; a table has two spaces between its columns.
  const std::regex columns("\\S  +\\S.*  +\\S");
  for (const Words& words : commands()) {
    if (words[0] == "--help" || words[0] == "help" || words[0] == "log")
      continue;  // not tables of ours
    constexpr unsigned short width = 40;
    const Ended ended = test::on_terminal(folder->path(), words, {width, "xterm"});
    EXPECT_EQ(ended.code, 0) << words[0] << ": " << ended.out;
    for (const std::string& line : lines_of(ended.out)) {
      if (!std::regex_search(line, columns) || line.find(',') != std::string::npos) continue;
      EXPECT_LE(text::width_of(line), width) << words[0] << ": " << line;
    }
  }
}

TEST_F(EveryCommand, SendsADumbTerminalNoEscapeSequence) {
  for (const Words& words : commands()) {
    const Ended ended = test::on_terminal(folder->path(), words, {40, "dumb"});
    EXPECT_EQ(ended.code, 0) << words[0] << ": " << ended.out;
    EXPECT_EQ(ended.out.find('\x1b'), std::string::npos) << words[0];
  }
}

TEST_F(EveryCommand, PrintsNothingWhenItIsToBeQuiet) {
  for (Words words : commands()) {
    const std::set<std::string> always = {"log", "help", "--help", "--version"};
    if (always.contains(words[0]) ||
        words == Words{"catalogue", "export", "--db", "impacts.sqlite"})
      continue;
    words.push_back("--quiet");
    const Ended ended = test::eerie(folder->path(), words);
    EXPECT_EQ(ended.code, 0) << words[0] << ": " << ended.err;
    EXPECT_EQ(ended.out, "") << words[0];
  }
}

/// A run long enough for its progress to be drawn a few times.
class Progress : public testing::Test {
 protected:
  Progress() { test::write_sweep(folder.path(), 20000, R"({"v_imp_cm_per_s": [15, 16, 17, 18]})"); }
  Words run = {"run", "sweep.json", "--workers", "2"};
  test::TemporaryFolder folder;
};

TEST_F(Progress, StaysInOneLineThatFitsTheTerminal) {
  for (const char* kind : {"xterm", "dumb"}) {
    std::filesystem::remove(folder / "eerie.sqlite");
    std::filesystem::remove_all(folder / "eerie.sqlite.jobs");
    const Ended ended = test::on_terminal(folder.path(), run, {38, kind});
    ASSERT_EQ(ended.code, 0) << ended.out;
    std::size_t drawn = 0;
    std::istringstream parts(std::regex_replace(ended.out, std::regex("\x1b\\[K"), ""));
    for (std::string part; std::getline(parts, part, '\r');) {
      if (part.find(" done, ") == std::string::npos || part.find('\n') != std::string::npos)
        continue;
      ++drawn;
      EXPECT_LT(text::width_of(part), 38u) << part;
    }
    EXPECT_GT(drawn, 0u) << ended.out;
    const auto lines = lines_of(ended.out);
    EXPECT_LE(std::ranges::count_if(
                  lines, [](const std::string& line) { return line.ends_with(" running"); }),
              1)
        << "each look began a line of its own";
  }
}

TEST_F(Progress, IsNotShownToWhoeverAskedForQuiet) {
  install_text(folder / "scene.json",
               R"({"numerics": {"particles_per_target": 100}, "end": {"time_s": 300}})");
  const std::vector<Words> commands = {run,
                                       {"doctor"},
                                       {"analyse", "--db", "eerie.sqlite"},
                                       {"solve", "scene.json", "--out", "one"}};
  for (Words words : commands) {
    words.push_back("--quiet");
    const Ended ended = test::on_terminal(folder.path(), words, {80, "xterm"});
    EXPECT_EQ(ended.code, 0) << words[0] << ": " << ended.out;
    for (const std::string& line : lines_of(ended.out))
      EXPECT_TRUE(line.starts_with("warning: ")) << words[0] << ": " << line;
  }
}

TEST_F(Progress, NobodyReadsItAndTheRunGoesOn) {
  EXPECT_EQ(test::complaining_to_nobody(folder.path(), run).code, 0);
  const Ended status = test::eerie(folder.path(), {"status", "--json"});
  EXPECT_EQ(nlohmann::json::parse(status.out).at("sweeps").at(0).at("jobs").at("done"), 4);
}

class HostileText : public testing::Test {
 protected:
  /// The tests' own lines of what was said must not begin where a file wants one to.
  static void expect_plain(const Ended& ended) {
    const std::string all = ended.out + ended.err;
    EXPECT_EQ(all.find('\x1b'), std::string::npos) << all;
    for (const std::string& line : lines_of(all)) EXPECT_FALSE(line.starts_with("forged")) << all;
  }
  test::TemporaryFolder folder;
};

TEST_F(HostileText, OfASweepIsShownAndNotObeyed) {
  install_text(folder / "sweep.json",
               R"({"name": "a\u001b[2Jb\nforged: line", "scene": {"end": {"time_s": 300}},
                   "grid": {"v_imp_cm_per_s": [15]}})");
  expect_plain(test::eerie(folder.path(), {"expand", "sweep.json"}));
  install_text(folder / "e\x1b[31m.json", "{}");
  const Ended ended = test::eerie(folder.path(), {"expand", "e\x1b[31m.json"});
  expect_plain(ended);
  EXPECT_THAT(ended.err, HasSubstr("e\\x1b[31m.json"));
}

TEST_F(HostileText, OfALogIsShownAndNotObeyed) {
  test::write_sweep(folder.path(), 300, R"({"v_imp_cm_per_s": [15]})");
  ASSERT_EQ(test::eerie(folder.path(), {"run", "sweep.json"}).code, 0);
  const auto job = test::job_directories(folder / "eerie.sqlite").at(0);
  std::ofstream(job / "log.txt", std::ios::app) << "title \x1b]0;owned\x07\n";
  const Ended ended = test::eerie(folder.path(), {"log", job.filename().string().substr(0, 8)});
  expect_plain(ended);
  EXPECT_THAT(ended.out, HasSubstr("title \\x1b]0;owned\\x07\n"));
}

}  // namespace
}  // namespace eerie
