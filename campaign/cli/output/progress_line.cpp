#include "campaign/cli/output/progress_line.hpp"

#include <fmt/format.h>

#include "campaign/text/layout.hpp"
#include "campaign/text/quantities.hpp"

namespace eerie::cli {
namespace {

constexpr std::size_t bar_width = 24;

std::string bar(const manager::CampaignView& view) {
  if (view.total == 0) return "";
  const std::size_t filled = bar_width * (view.done + view.failed) / view.total;
  return "[" + std::string(filled, '#') + std::string(bar_width - filled, '-') + "] ";
}

std::string counts(const manager::CampaignView& view) {
  std::string out = fmt::format("{}/{} done", view.done, view.total);
  if (view.failed > 0) out += fmt::format(", {} failed", view.failed);
  if (view.paused > 0) out += fmt::format(", {} paused", view.paused);
  return out + ", ";
}

}  // namespace

std::string progress_text(const manager::CampaignView& view, bool with_bar) {
  return (with_bar ? bar(view) : "") + counts(view) + progress_tail(view);
}

std::string progress_fitting(const manager::CampaignView& view, std::size_t width, bool with_bar) {
  std::string out = progress_text(view, with_bar);
  if (width == 0 || text::width_of(out) <= width) return out;
  out = progress_text(view, false);
  if (text::width_of(out) <= width) return out;
  return text::cut(counts(view) + progress_tail(view, false), width);
}

std::string progress_tail(const manager::CampaignView& view, bool with_speed) {
  std::string out = fmt::format("{} running", view.running);
  if (view.stopping)
    return out + " | stopping: workers write their checkpoints (Ctrl-C again: at once)";
  if (!view.waiting_for.empty()) return out + " | waiting: " + view.waiting_for;
  if (with_speed && view.particle_steps_per_s > 0)
    out += fmt::format(" | {} particle-steps/s", text::magnitude(view.particle_steps_per_s));
  if (view.eta_s >= 0) out += " | ETA " + text::duration(view.eta_s);
  return out;
}

}  // namespace eerie::cli
