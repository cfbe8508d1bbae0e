#include "campaign/process/hook.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie::process {
namespace {
using testing::HasSubstr;
namespace fs = std::filesystem;

class HookTest : public testing::Test {
 protected:
  /// A script that writes its argument and one variable beside itself, whole at once.
  fs::path script(const std::string& name, const std::string& shebang = "#!/bin/sh\n") {
    const fs::path path = folder_.path() / name;
    install_text(path, shebang +
                           "printf '%s|%s' \"$1\" \"$EERIE_FACT\" > \"$0.new\"\n"
                           "mv \"$0.new\" \"$0.said\"\n");
    ::chmod(path.c_str(), 0755);
    return path;
  }
  static std::string said_by(const fs::path& path) {
    const fs::path said = path.string() + ".said";
    EXPECT_TRUE(test::eventually([&] { return fs::exists(said); }));
    return read_file(said);
  }
  test::TemporaryFolder folder_;
};

TEST_F(HookTest, TellsTheEventAndTheFacts) {
  const fs::path program = script("tell me; $(touch x)");  // a name, and nothing more
  EXPECT_EQ(Hook(program.string()).tell("idle", {{"EERIE_FACT", "15"}}), "");
  EXPECT_EQ(said_by(program), "idle|15");
}

TEST_F(HookTest, NoShellReadsWhatIsTold) {
  const fs::path program = script("notify");
  const std::string words = "a b; $(touch injected) `touch injected` 'x' \"y\" \n*";
  EXPECT_EQ(Hook(program.string()).tell("idle", {{"EERIE_FACT", words}}), "");
  EXPECT_EQ(said_by(program), "idle|" + words);
  EXPECT_FALSE(fs::exists(folder_ / "injected"));
  EXPECT_FALSE(fs::exists("injected"));
}

TEST_F(HookTest, AProgramThatIsNoneIsRefusedBeforehand) {
  install_text(folder_ / "text", "no program");
  for (const std::string& name :
       {(folder_ / "none").string(), (folder_ / "text").string(), folder_.path().string(),
        std::string("no-such-program-on-the-path"), std::string("notify-send done")})
    EXPECT_THROW(Hook{name}, InputError) << name;
  EXPECT_EQ(Hook("").tell("idle", {}), "");
  EXPECT_EQ(Hook("true").tell("idle", {}), "");
}

TEST_F(HookTest, WhatCannotBeStartedIsSaidAndStopsNothing) {
  const fs::path program = script("odd", "#!/no/such/interpreter\n");
  EXPECT_THAT(Hook(program.string()).tell("idle", {}), HasSubstr("No such file"));
}

}  // namespace
}  // namespace eerie::process
