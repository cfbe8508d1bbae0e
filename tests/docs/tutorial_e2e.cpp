#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <regex>
#include <sstream>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/markdown.hpp"
#include "tests/support/paths.hpp"

namespace eerie {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

/// A line of the tutorial as the test runs it: settings by name become tiny ones, of 150 and 160
/// particles per target for 300 s, and are chosen by these numbers.
std::string with_tiny_settings(std::string line) {
  const bool runs = line.find("eerie run") != std::string::npos ||
                    line.find("eerie expand") != std::string::npos ||
                    line.find("eerie solve") != std::string::npos;
  const bool asks = line.find("eerie query") != std::string::npos;
  for (const auto& [name, particles] :
       {std::pair{"sketch", "150"}, {"survey", "160"}, {"standard", "160"}}) {
    const std::string tiny =
        runs ? fmt::format("--set numerics.particles_per_target={} --set end.time_s=300", particles)
        : asks ? fmt::format("--where particles_per_target={}", particles)
               : fmt::format("--particles {}", particles);
    line = std::regex_replace(line, std::regex(std::string("--fidelity ") + name), tiny);
  }
  return line;
}

/// The commands of the page as one script.
std::string script_of(const std::string& page) {
  std::string script = "set -eu\n", line;
  std::istringstream lines(test::code_of(page, "sh"));
  while (std::getline(lines, line)) script += with_tiny_settings(line) + "\n";
  return script;
}

TEST(Tutorial, EveryCommandOfThePageRunsAndLeavesTheFilesThatItNames) {
  const test::TemporaryFolder folder;
  const std::string page = read_file(test::source_folder() / "docs/tutorial/README.md");
  const std::string script = script_of(page);
  ASSERT_THAT(script, HasSubstr("build/eerie run"));
  ASSERT_THAT(script, testing::Not(HasSubstr("--fidelity")));
  fs::create_directory(folder / "build");
  fs::create_symlink(test::program(), folder / "build/eerie");
  install_text(folder / "tutorial.sh", script);
  const int status = std::system(
      fmt::format("cd '{}' && sh tutorial.sh > out.txt 2> err.txt", folder.path().string())
          .c_str());
  EXPECT_EQ(status, 0) << read_file(folder / "err.txt");
  const std::string out = read_file(folder / "out.txt");
  EXPECT_THAT(out, HasSubstr("mine: 63 jobs"));
  EXPECT_THAT(out, HasSubstr("63 of 63 jobs done"));
  EXPECT_THAT(out, HasSubstr("12 of 12 jobs done"));
  EXPECT_THAT(out, HasSubstr("10 of 10 jobs done"));
  for (const char* file : {"mine-b-over-a.png", "impact.png", "figure.pdf", "figure.csv"})
    EXPECT_TRUE(fs::exists(folder.path() / file)) << file;
}

}  // namespace
}  // namespace eerie
