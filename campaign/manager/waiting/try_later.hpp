#pragma once

#include <chrono>
#include <string>

#include "campaign/manager/scheduler.hpp"

namespace eerie::manager {

/// The engine takes no work before some time is over.
struct TryLater : SchedulerUnavailable {
  TryLater(const std::string& reason, std::chrono::seconds wait)
      : SchedulerUnavailable(reason), patience(wait) {}

  std::chrono::seconds patience;
};

}  // namespace eerie::manager
