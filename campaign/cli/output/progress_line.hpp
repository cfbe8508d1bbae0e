#pragma once

#include <string>

#include "campaign/manager/manager.hpp"

namespace eerie::cli {

/// The line "[######----] 3/15 done, 1 failed, 2 running | 1.9 M particle-steps/s | ETA 3 min 20
/// s".
std::string progress_text(const manager::CampaignView& view, bool with_bar);
/// The line in at most `width` columns (0: no limit), without its least important parts.
std::string progress_fitting(const manager::CampaignView& view, std::size_t width, bool with_bar);
/// The part of the line from "2 running" on.
std::string progress_tail(const manager::CampaignView& view, bool with_speed = true);

}  // namespace eerie::cli
