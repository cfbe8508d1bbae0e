#pragma once

#include <optional>

#include "campaign/manager/manager.hpp"

namespace eerie::manager {

/// Finds the moments at which a campaign has nothing left to do.
class Idleness {
 public:
  enum class Moment { idle, idle_with_new_failures };
  /// Looks at the campaign; something at the moment when it falls idle, once per time of work.
  std::optional<Moment> look(const CampaignView& view);

 private:
  bool has_worked_ = false;
  std::optional<std::size_t> finished_;  ///< jobs done or failed at the last look
  std::size_t failed_ = 0;               ///< failed jobs at the last such moment
};

}  // namespace eerie::manager
