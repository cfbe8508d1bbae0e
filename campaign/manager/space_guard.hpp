#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace eerie::manager {

/// Watches the disks of a campaign, so that it waits for room instead of failing for want of it.
class SpaceGuard {
 public:
  using Clock = std::chrono::steady_clock;

  SpaceGuard(std::vector<std::filesystem::path> folders, std::uintmax_t least_free)
      : folders_(std::move(folders)), least_free_(least_free) {}

  /// Somebody found a disk full: it counts as full for a while, each time twice as long, or until
  /// there is clearly more room.
  void was_full(Clock::time_point now);
  /// A job got through.
  void was_well() { patience_ = first_patience; }

  /// Why work has to wait, or nothing.
  std::optional<std::string> complaint(Clock::time_point now);

 private:
  static constexpr std::chrono::seconds first_patience{1}, longest_patience{300};

  std::uintmax_t free_in_all() const;

  std::vector<std::filesystem::path> folders_;
  std::uintmax_t least_free_;
  Clock::time_point full_until_{};
  std::chrono::seconds patience_ = first_patience;
  bool doubted_ = false;  ///< found full since room was last tried
  std::uintmax_t free_when_full_ = 0;
};

/// Waits until a folder has so much room; `tell` hears once why. False: a stop was asked for first.
bool wait_for_room(const std::filesystem::path& folder, std::uintmax_t least_free,
                   const std::function<void(const std::string&)>& tell);

}  // namespace eerie::manager
