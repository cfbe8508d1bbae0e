#pragma once

#include <chrono>
#include <string>

#include "campaign/manager/manager.hpp"

namespace eerie::cli {

/// Shows a campaign at work on stderr: a bar that redraws itself on a terminal, else a line at
/// most every ten seconds.
class ProgressLine {
 public:
  ProgressLine();
  void show(const manager::CampaignView& view);
  void finish();  ///< leaves the terminal's line

 private:
  bool terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point next_;
};

/// Shows "examined 3 of 15" on stderr where that is a terminal; leaves its line at the last.
void show_count(const char* verb, std::size_t done, std::size_t all);

/// "[######----] 3/15 done, 1 failed, 2 running | 1.9 M particle-steps/s | ETA 3 min 20 s".
std::string progress_text(const manager::CampaignView& view, bool with_bar);
/// The part from "2 running" on.
std::string progress_tail(const manager::CampaignView& view);

}  // namespace eerie::cli
