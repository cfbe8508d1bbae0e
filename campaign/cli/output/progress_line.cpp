#include "campaign/cli/output/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "campaign/cli/output/text_table.hpp"

namespace eerie::cli {
namespace {
constexpr std::size_t bar_width = 24;
}

std::string progress_text(const manager::CampaignView& view, bool with_bar) {
  std::string text;
  if (with_bar && view.total > 0) {
    const std::size_t filled = bar_width * (view.done + view.failed) / view.total;
    text += "[" + std::string(filled, '#') + std::string(bar_width - filled, '-') + "] ";
  }
  text += fmt::format("{}/{} done", view.done, view.total);
  if (view.failed > 0) text += fmt::format(", {} failed", view.failed);
  if (view.paused > 0) text += fmt::format(", {} paused", view.paused);
  return text + ", " + progress_tail(view);
}

std::string progress_tail(const manager::CampaignView& view) {
  std::string text = fmt::format("{} running", view.running);
  if (view.stopping)
    return text + " | stopping: workers write their checkpoints (Ctrl-C again: at once)";
  if (!view.waiting_for.empty()) return text + " | waiting: " + view.waiting_for;
  if (view.particle_steps_per_s > 0)
    text += fmt::format(" | {} particle-steps/s", magnitude(view.particle_steps_per_s));
  if (view.eta_s >= 0) text += " | ETA " + duration(view.eta_s);
  return text;
}

ProgressLine::ProgressLine()
    : terminal_(::isatty(STDERR_FILENO) != 0),
      next_(std::chrono::steady_clock::now() +
            (terminal_ ? std::chrono::seconds(0) : std::chrono::seconds(10))) {}

void ProgressLine::show(const manager::CampaignView& view) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + (terminal_ ? std::chrono::milliseconds(500) : std::chrono::seconds(10));
  if (terminal_)
    fmt::print(stderr, "\r\033[K{}", progress_text(view, true));
  else
    fmt::print(stderr, "{}\n", progress_text(view, false));
  std::fflush(stderr);
  drawn_ = true;
}

void show_count(const char* verb, std::size_t done, std::size_t all) {
  if (::isatty(STDERR_FILENO) == 0) return;
  fmt::print(stderr, "\r\033[K{} {} of {}", verb, done, all);
  if (done == all) fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

void ProgressLine::finish() {
  if (terminal_ && drawn_) fmt::print(stderr, "\r\033[K");
}

}  // namespace eerie::cli
