#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <regex>
#include <sstream>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

/// What a command of the shell prints, complaints too, and at last how it ended.
std::string said_by(const std::string& command) {
  std::string text;
  std::FILE* pipe = ::popen(("{ " + command + "; } 2>&1").c_str(), "r");
  std::array<char, 4096> part;
  for (std::size_t n; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
    text.append(part.data(), n);
  if (const int status = ::pclose(pipe); status != 0) text += "status " + std::to_string(status);
  return text;
}

/// First groups of every line that matches.
std::vector<std::string> found(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> words;
  std::istringstream lines(text);
  std::smatch match;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, match, pattern)) words.push_back(match[1]);
  return words;
}

/// Pages and completions as `eerie manual -o` writes them, beside what --help says.
class ManualFiles : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new test::TemporaryFolder;
    ASSERT_EQ(test::eerie(folder->path(), {"manual", "-o", "."}).code, 0);
    commands = found(help({}), std::regex("^  ([a-z][a-z-]+)( |$)"));
    ASSERT_GE(commands.size(), 25u);
  }
  static void TearDownTestSuite() { delete folder; }

  static std::string help(std::vector<std::string> words) {
    words.push_back("--help");
    return test::eerie(folder->path(), words).out;
  }
  /// Options of a command by its --help: "--db", "-o", ...
  static std::vector<std::string> options(const std::vector<std::string>& words) {
    std::vector<std::string> names;
    for (const std::string& list : found(help(words), std::regex("^  (-[a-zA-Z,-]+)"))) {
      std::istringstream parts(list);
      for (std::string name; std::getline(parts, name, ',');) names.push_back(name);
    }
    return names;
  }
  static std::string page(const std::string& command) {
    std::string text = read_file(folder->path() / ("man/eerie-" + command + ".1"));
    return std::regex_replace(text, std::regex("\\\\-"), "-");
  }
  /// The words that bash offers for the last of these.
  static std::vector<std::string> bash(const std::string& words) {
    const std::string script = "source completions/eerie; COMP_WORDS=(" + words +
                               "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _eerie; "
                               "printf '%s\\n' \"${COMPREPLY[@]}\"";
    install_text(*folder / "try.bash", script);
    return found(said_by("cd " + folder->path().string() + " && bash --norc try.bash"),
                 std::regex("^(.+)$"));
  }

  static inline test::TemporaryFolder* folder = nullptr;
  static inline std::vector<std::string> commands;
};

TEST_F(ManualFiles, EveryCommandAndOptionIsInItsPageAndInTheCompletions) {
  const std::string zsh = read_file(*folder / "completions/_eerie"),
                    fish = read_file(*folder / "completions/eerie.fish");
  std::size_t tried = 0;
  for (const std::string& command : commands) {
    const std::string text = page(command);
    const std::vector<std::string> offered = bash("eerie " + command + " -");
    EXPECT_THAT(zsh, HasSubstr("_eerie_" + command + "() {"));
    EXPECT_THAT(fish, HasSubstr(" -a " + command + " -d "));
    const std::vector<std::string> names = options({command});
    EXPECT_THAT(offered, testing::IsSupersetOf(names)) << command;
    const std::size_t begin = zsh.find("_eerie_" + command + "() {");
    const std::string function = zsh.substr(begin, zsh.find("\n}\n", begin) - begin);
    for (const std::string& name : names) {
      ++tried;
      EXPECT_THAT(text, HasSubstr("\\fB" + name + "\\fR")) << command;
      EXPECT_TRUE(std::regex_search(function, std::regex("'[*]?" + name + "=?\\[")))
          << command << " " << name;
      const bool is_long = name.starts_with("--");
      EXPECT_TRUE(
          std::regex_search(fish, std::regex("from " + command + "'.* -" + (is_long ? "l " : "s ") +
                                             name.substr(is_long ? 2 : 1) + " ")))
          << command << " " << name;
    }
  }
  EXPECT_GT(tried, 150u);
  EXPECT_THAT(bash("eerie ''"), testing::IsSupersetOf(commands));
}

TEST_F(ManualFiles, PagesAreWithoutFault) {
  for (const auto& entry : fs::directory_iterator(*folder / "man")) {
    const std::string file = entry.path().string();
    // Pages have no date, so that equal sources give equal pages.
    EXPECT_THAT(found(said_by("mandoc -T lint -W warning " + file),
                      std::regex("^(?!.*missing date)(.*(mandoc:|not found).*)$")),
                testing::IsEmpty());
    EXPECT_EQ(said_by("LC_ALL=C.UTF-8 groff -man -ww -T utf8 -z " + file), "");
  }
  const std::string shown = said_by("MANWIDTH=80 LC_ALL=C.UTF-8 man -l " +
                                    (*folder / "man/eerie-run.1").string() + " | col -bx");
  EXPECT_THAT(shown, HasSubstr("--fidelity TEXT\n"));
  EXPECT_THAT(shown, HasSubstr("eerie run sweeps/first-light.json\n"));
  EXPECT_THAT(shown, HasSubstr("EXIT STATUS\n"));
}

TEST_F(ManualFiles, BashCompletesCommandsOptionsAndWords) {
  EXPECT_THAT(bash("eerie thr"), UnorderedElementsAre("threshold"));
  EXPECT_THAT(bash("eerie query --of ''"), UnorderedElementsAre("results", "remnants", "maps"));
  EXPECT_THAT(bash("eerie query --of = re"), UnorderedElementsAre("results", "remnants"));
  EXPECT_THAT(bash("eerie query --colu"), UnorderedElementsAre("--columns"));
  EXPECT_THAT(bash("eerie catalogue ''"), UnorderedElementsAre("export", "import", "compare"));
  EXPECT_THAT(bash("eerie catalogue export --d"), UnorderedElementsAre("--db"));
  // Where files may stand bash goes on by itself, and says nothing of options.
  EXPECT_THAT(bash("eerie run ''"), testing::IsEmpty());
  EXPECT_THAT(bash("eerie query --db ''"), testing::IsEmpty());
  EXPECT_THAT(bash("eerie query --limit ''"), testing::IsEmpty());
}

TEST_F(ManualFiles, FishCompletesCommandsOptionsAndWords) {
  const auto fish = [](const std::string& words) {
    return found(said_by("cd " + folder->path().string() +
                         " && HOME=$PWD fish -N -c 'source "
                         "completions/eerie.fish; complete -C \"" +
                         words + "\"'"),
                 std::regex("^([^\t]+)"));
  };
  EXPECT_THAT(fish("eerie thr"), UnorderedElementsAre("threshold"));
  EXPECT_THAT(fish("eerie query --of "), UnorderedElementsAre("results", "remnants", "maps"));
  EXPECT_THAT(fish("eerie query --colu"), UnorderedElementsAre("--columns"));
  EXPECT_THAT(fish("eerie catalogue im"), UnorderedElementsAre("import"));
}

TEST_F(ManualFiles, ZshReadsItsScript) {
  EXPECT_EQ(said_by("zsh -f -n " + (*folder / "completions/_eerie").string()), "");
}

TEST_F(ManualFiles, OfAnUnknownCommandTheReasonIsSaid) {
  const test::Ended ended = test::eerie(folder->path(), {"manual", "rum"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("no page of \"rum\""));
}

}  // namespace
}  // namespace eerie
