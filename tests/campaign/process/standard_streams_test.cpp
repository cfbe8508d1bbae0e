#include "campaign/process/standard_streams.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <cstdlib>

namespace eerie::process {
namespace {

/// Sets variables of the environment as long as it lives.
class Environment {
 public:
  Environment(const char* columns, const char* kind) { set("COLUMNS", columns), set("TERM", kind); }
  ~Environment() { set("COLUMNS", nullptr), set("TERM", "dumb"); }

 private:
  static void set(const char* name, const char* value) {
    if (value == nullptr)
      ::unsetenv(name);
    else
      ::setenv(name, value, 1);
  }
};

TEST(TerminalAt, KnowsItsWidthAndWhatItObeys) {
  const winsize size{24, 47, 0, 0};
  int master = -1, slave = -1;
  ASSERT_EQ(::openpty(&master, &slave, nullptr, nullptr, &size), 0);
  {
    const Environment environment(nullptr, "xterm");
    const Terminal terminal = terminal_at(slave);
    EXPECT_TRUE(terminal.is_one);
    EXPECT_FALSE(terminal.is_dumb);
    EXPECT_EQ(terminal.width, 47u);
  }
  {
    const Environment environment("30", "dumb");
    const Terminal terminal = terminal_at(slave);
    EXPECT_TRUE(terminal.is_dumb);
    EXPECT_EQ(terminal.width, 30u);
  }
  ::close(master), ::close(slave);
}

TEST(TerminalAt, AFileIsAsWideAsALineNeedsUnlessColumnsSaysSo) {
  const int file = ::open("/dev/null", O_WRONLY);
  {
    const Environment environment(nullptr, "xterm");
    EXPECT_FALSE(terminal_at(file).is_one);
    EXPECT_EQ(terminal_at(file).width, 0u);
  }
  for (const char* nonsense : {"", "-5", "wide", "0"}) {
    const Environment environment(nonsense, "xterm");
    EXPECT_EQ(terminal_at(file).width, 0u) << nonsense;
  }
  const Environment environment("60", "xterm");
  EXPECT_EQ(terminal_at(file).width, 60u);
  ::close(file);
}

TEST(WriteAll, SaysWhyItCouldNot) {
  const int full = ::open("/dev/full", O_WRONLY), reading = ::open("/dev/null", O_RDONLY);
  EXPECT_EQ(write_all(full, "text"), ENOSPC);
  EXPECT_EQ(write_all(reading, "text"), EBADF);
  EXPECT_EQ(write_all(full, ""), 0);
  ::close(full), ::close(reading);
}

}  // namespace
}  // namespace eerie::process
