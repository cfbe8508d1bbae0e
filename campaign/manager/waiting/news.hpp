#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "campaign/manager/campaign_run.hpp"
#include "campaign/manager/waiting/idleness.hpp"

namespace eerie::manager {

/// What a user's program is told of a campaign: an event, and facts in its environment.
struct News {
  std::string event = {};          ///< ended, stopped, idle or failed
  std::string sweep = {};          ///< EERIE_SWEEP; empty: not told
  std::string message = {};        ///< EERIE_MESSAGE; empty: not told
  std::optional<Tally> jobs = {};  ///< EERIE_JOBS, EERIE_DONE, EERIE_FAILED, EERIE_LEFT
};

/// Of a campaign that has fallen idle.
News news_of(Idleness::Moment moment, const CampaignView& view);

/// Runs `program` with the news and the database's path (EERIE_DATABASE), and does not wait for it.
/// Returns why it could not be started, or nothing. Throws InputError where there is no such
/// program; an empty name is none and is told nothing.
std::string tell(const std::string& program, const std::filesystem::path& database,
                 const News& news);

}  // namespace eerie::manager
