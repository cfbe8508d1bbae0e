#include "analysis/drawing/tool.hpp"

#include <gmock/gmock.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::drawing {
namespace {
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Tool, RunsWithoutAShellAndSaysWhatWentWrong) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(run_tool({"cat", "", ""}, {}, "$HOME; x", folder / "out").well);
  EXPECT_EQ(read_file(folder / "out"), "$HOME; x");
  const ToolEnd end = run_tool({"cat", "", ""}, {"/nothing/here"});
  EXPECT_FALSE(end.well);
  EXPECT_THAT(end.words, HasSubstr("/nothing/here"));
}

TEST(Tool, ThatIsMissingIsNamedWithItsPackage) {
  const Tool missing{"no-such-program", "does things", "some-package"};
  const char* words =
      "no-such-program is not installed and does things; install it: apt-get "
      "install some-package";
  EXPECT_THAT([&] { run_tool(missing, {}); }, ThrowsMessage<EnvironmentError>(HasSubstr(words)));
  EXPECT_THAT([&] { require_tool(missing); }, ThrowsMessage<EnvironmentError>(HasSubstr(words)));
  EXPECT_NO_THROW(require_tool({"cat", "", ""}));
}

}  // namespace
}  // namespace eerie::drawing
