#pragma once

#include <string>

#include "campaign/manager/manager.hpp"

namespace eerie::cli {

/// "[######----] 3/15 done, 1 failed, 2 running | 1.9 M particle-steps/s | ETA 3 min 20 s".
std::string progress_text(const manager::CampaignView& view, bool with_bar);
/// The same in at most `width` columns (0: any), without what matters least.
std::string progress_fitting(const manager::CampaignView& view, std::size_t width, bool with_bar);
/// The part from "2 running" on.
std::string progress_tail(const manager::CampaignView& view, bool with_speed = true);

}  // namespace eerie::cli
