#include "campaign/process/signals.hpp"

#include <poll.h>
#include <signal.h>

#include <atomic>
#include <initializer_list>

namespace eerie::process {
namespace {

std::atomic<int> requests{0}, seen{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may touch nothing else");

void count_request(int) { ++requests; }
void wake(int) {}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

/// Whoever started this process may have said that a signal is none of its business (nohup).
bool is_ignored(int signal) {
  struct sigaction present {};
  return sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
}

sigset_t set_of(std::initializer_list<int> signals) {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : signals) sigaddset(&set, signal);
  return set;
}

}  // namespace

void catch_stop_signals() {
  handle(SIGINT, count_request);
  handle(SIGTERM, count_request);
  handle(SIGUSR1, count_request);
  if (!is_ignored(SIGHUP)) handle(SIGHUP, count_request);
  // Whoever read the progress may leave: that ends no campaign. A write then fails with EPIPE.
  handle(SIGPIPE, SIG_IGN);
}

int stop_requests() { return seen = requests.load(); }
bool has_unseen_stop_request() { return seen < requests; }

void hold_signals() {
  handle(SIGCHLD, wake);
  const sigset_t held = set_of({SIGINT, SIGTERM, SIGUSR1, SIGHUP, SIGCHLD});
  pthread_sigmask(SIG_BLOCK, &held, nullptr);
}

void wait_for_signal(std::chrono::milliseconds longest) {
  const timespec time{longest.count() / 1000, (longest.count() % 1000) * 1'000'000};
  const sigset_t nothing_held = set_of({});
  ppoll(nullptr, 0, &time, &nothing_held);
}

}  // namespace eerie::process
