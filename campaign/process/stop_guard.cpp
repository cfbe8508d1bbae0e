#include "campaign/process/stop_guard.hpp"

#include <signal.h>
#include <unistd.h>

#include <string_view>

#include "campaign/process/signals.hpp"
#include "solver/base/error.hpp"

namespace eerie::process {
namespace {

using Clock = std::chrono::steady_clock;

/// Of a manager that holds its signals until it waits.
bool is_held() {
  sigset_t held;
  if (sigpending(&held) != 0) return false;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1})
    if (sigismember(&held, signal) == 1) return true;
  return false;
}

[[noreturn]] void end_at_once() {
  constexpr std::string_view text =
      "eerie: told to stop and hung: ended at once; nothing that was done is lost\n";
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(static_cast<int>(ExitCode::environment));
}

void watch(const std::stop_token& over, std::chrono::milliseconds longest) {
  constexpr auto interval = std::chrono::milliseconds(250);
  Clock::time_point heard = Clock::now();
  while (!over.stop_requested()) {
    std::this_thread::sleep_for(std::min(interval, longest));
    if (!is_held() && !has_unseen_stop_request())
      heard = Clock::now();
    else if (Clock::now() - heard >= longest)
      end_at_once();
  }
}

}  // namespace

StopGuard::StopGuard(std::chrono::milliseconds longest) {
  // Stop signals are for the main thread, whose waits they end.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::jthread([longest](const std::stop_token& over) { watch(over, longest); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace eerie::process
