#include "campaign/manager/space_guard.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/process/signals.hpp"
#include "solver/base/free_space.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;

namespace {

/// What a worker needs at least to say how it ended.
constexpr std::uintmax_t probe_bytes = 1 << 20;

}  // namespace

void SpaceGuard::was_full(Clock::time_point now) {
  if (doubted_ && now < full_until_) return;  // nobody has tried again since
  doubted_ = true;
  free_when_full_ = free_in_all();
  full_until_ = now + patience_;
  patience_ = std::min(2 * patience_, longest_patience);
}

std::uintmax_t SpaceGuard::free_in_all() const {
  std::uintmax_t sum = 0;
  for (const fs::path& folder : folders_) sum += free_bytes(folder).value_or(0);
  return sum;
}

std::optional<std::string> SpaceGuard::complaint(Clock::time_point now) {
  for (const fs::path& folder : folders_) {
    const auto free = free_bytes(folder);
    if (free && *free < least_free_)
      return fmt::format("disk full: {:.1f} MB free on {}, wanted are {:.1f} MB; free some",
                         static_cast<double>(*free) / 1e6, folder.string(),
                         static_cast<double>(least_free_) / 1e6);
    if (doubted_ && !has_room(folder, probe_bytes))
      return fmt::format("disk full: not {} bytes can be written in {}; free some", probe_bytes,
                         folder.string());
  }
  constexpr std::uintmax_t clearly = 1 << 20;
  if (now < full_until_ && free_in_all() < 2 * free_when_full_ + clearly)
    return fmt::format(
        "a worker found the disk full; trying again in {} s",
        std::chrono::duration_cast<std::chrono::seconds>(full_until_ - now).count() + 1);
  doubted_ = false;
  return std::nullopt;
}

bool wait_for_room(const std::filesystem::path& folder, std::uintmax_t least_free,
                   const std::function<void(const std::string&)>& tell) {
  SpaceGuard guard({folder}, least_free);
  for (bool told = false; process::stop_requests() == 0; told = true) {
    const auto complaint = guard.complaint(SpaceGuard::Clock::now());
    if (!complaint) return true;
    if (!told) tell("waiting: " + *complaint);
    process::wait_for_signal(std::chrono::seconds(1));
  }
  return false;
}

}  // namespace eerie::manager
