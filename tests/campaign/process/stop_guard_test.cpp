#include "campaign/process/stop_guard.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "campaign/process/signals.hpp"
#include "solver/base/error.hpp"

namespace eerie::process {
namespace {
using namespace std::chrono_literals;

/// How a process ends that does `body` under a guard, and 0 after it.
template <class Body>
int ended(Body&& body) {
  const pid_t child = ::fork();
  if (child == 0) {
    catch_stop_signals();
    const StopGuard guard(300ms);
    body();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// As in the open() of a pipe that nobody writes to; no signal ends it.
void hang() {
  for (int k = 0; k < 200; ++k) ::usleep(100'000);
}

TEST(StopGuard, EndsAProcessThatIsToldToStopAndHangs) {
  const int environment = static_cast<int>(ExitCode::environment);
  EXPECT_EQ(ended([] { ::kill(::getpid(), SIGTERM), hang(); }), environment);
  EXPECT_EQ(ended([] { hold_signals(), ::kill(::getpid(), SIGINT), hang(); }), environment);
}

TEST(StopGuard, LeavesAloneWhoLooksAtTheRequest) {
  const auto work = [] {
    ::kill(::getpid(), SIGTERM);
    for (int k = 0; k < 8; ++k) ::usleep(100'000), stop_requests();
  };
  EXPECT_EQ(ended(work), 0);
}

TEST(StopGuard, LeavesAloneWhoIsNotToldToStop) {
  EXPECT_EQ(ended([] { ::usleep(800'000); }), 0);
}

}  // namespace
}  // namespace eerie::process
