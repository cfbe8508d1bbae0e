#include "campaign/cli/output/status_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "campaign/cli/output/complain.hpp"
#include "campaign/text/layout.hpp"
#include "campaign/text/plain_text.hpp"
#include "campaign/text/quantities.hpp"

namespace eerie::cli {
namespace {

constexpr std::chrono::milliseconds between_looks{500};
constexpr std::chrono::seconds between_lines{10};

}  // namespace

StatusLine::StatusLine(Format format)
    : wanted_(format != Format::nothing),
      terminal_(process::terminal_at(STDERR_FILENO)),
      next_(std::chrono::steady_clock::now() +
            (terminal_.is_one ? std::chrono::seconds(0) : between_lines)) {}

void StatusLine::show(const Text& look) {
  const auto now = std::chrono::steady_clock::now();
  if (!wanted_ || now < next_) return;
  next_ = now + (terminal_.is_one ? between_looks : between_lines);
  if (!terminal_.is_one) {
    if (const std::string line = look(0, false); !line.empty()) complain(line);
    return;
  }
  terminal_ = process::terminal_at(STDERR_FILENO);  // its window may have changed
  const std::size_t width = terminal_.width - 1;    // the last column would begin another line
  draw(text::cut(text::plain_text(look(width, true)), width));
}

/// A dumb terminal cannot clear the line: spaces do.
void StatusLine::draw(const std::string& shown) {
  const std::size_t width = text::width_of(shown);
  const std::string rest(
      terminal_.is_dumb && drawn_ > width ? std::min(drawn_, terminal_.width - 1) - width : 0, ' ');
  process::write_all(
      STDERR_FILENO,
      "\r" + shown + (terminal_.is_dumb ? rest + (shown.empty() ? "\r" : "") : "\033[K"));
  drawn_ = width;
}

void StatusLine::finish() {
  if (terminal_.is_one && drawn_ > 0) draw("");
}

void CountLine::show(std::size_t done, std::size_t all) {
  line_.show([&](std::size_t, bool on_terminal) {
    return on_terminal
               ? fmt::format("{} {} of {}{}", verb_, done, all,
                             eta_.text(static_cast<double>(done) / static_cast<double>(all)))
               : std::string();
  });
  if (done == all) line_.finish();
}

std::string Eta::text(double part) {
  const Clock::time_point now = Clock::now();
  if (!begun_) begun_ = Begun{now, part};
  const double seconds = std::chrono::duration<double>(now - begun_->at).count();
  if (part <= begun_->part || part >= 1 || seconds < 1) return "";
  return fmt::format(" | ETA {}", text::duration(seconds * (1 - part) / (part - begun_->part)));
}

}  // namespace eerie::cli
