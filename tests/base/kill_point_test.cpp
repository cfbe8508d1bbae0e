#include "solver/base/kill_point.hpp"

#include <gmock/gmock.h>
#include <signal.h>

#include <fstream>
#include <regex>
#include <set>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"

namespace eerie {
namespace {
namespace fs = std::filesystem;

TEST(KillPoints, OfTheSourcesAreThoseOfTheTable) {
  const fs::path root = eerie::test::source_folder();
  const std::regex call("\\bkill_point\\(\\s*\"([^\"]+)\"");
  std::set<std::string> passed;
  for (const char* top : {"solver", "db", "analysis", "campaign"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      const std::string text = read_file(entry.path());
      for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it)
        passed.insert((*it)[1]);
    }
  EXPECT_EQ(passed, std::set<std::string>(kill_point_names.begin(), kill_point_names.end()));
}

/// What a process that armed `where` does while it writes a.txt twice, then b.txt.
void write_armed(const test::TemporaryFolder& folder, const char* where) {
  arm_kill_point(where);
  for (const char* name : {"a.txt", "a.txt", "b.txt"})
    install_text(folder / name, fs::exists(folder / name) ? "new" : "old");
  std::_Exit(0);
}

TEST(KillPoints, KillThePassingThatWasAskedFor) {
  struct Case {
    const char* where;
    const char *a, *b;  ///< content of the files afterwards; empty: not there
  };
  for (const Case& c :
       {Case{"install.before-write", "", ""}, Case{"install.before-rename", "", ""},
        Case{"install.before-folder-sync", "old", ""}, Case{"install.before-rename:2", "old", ""},
        Case{"install.before-sync@a.txt:2", "old", ""},
        Case{"install.before-sync@b.txt", "new", ""},
        Case{"install.before-folder-sync@b.txt:1", "new", "old"}}) {
    const test::TemporaryFolder folder;
    EXPECT_EXIT(write_armed(folder, c.where), testing::KilledBySignal(SIGKILL), "") << c.where;
    const auto content = [&](const char* name) {
      return fs::exists(folder / name) ? read_file(folder / name) : "";
    };
    EXPECT_EQ(content("a.txt"), c.a) << c.where;
    EXPECT_EQ(content("b.txt"), c.b) << c.where;
  }
}

TEST(KillPoints, ThatAreNeverPassedDoNothing) {
  const test::TemporaryFolder folder;
  for (const char* where :
       {"install.before-write@c.txt", "install.before-write:4", "checkpoint.between"})
    EXPECT_EXIT(write_armed(folder, where), testing::ExitedWithCode(0), "") << where;
}

TEST(KillPoints, OfUnknownNamesAreRefused) {
  for (const char* where : {"", "install", "install.before-rname", "install.before-sync:0",
                            "install.before-sync:", "install.before-sync:1x", "@result.json"})
    EXPECT_THROW(arm_kill_point(where), InputError) << where;
  EXPECT_FALSE(kill_points_are_armed);
}

}  // namespace
}  // namespace eerie
