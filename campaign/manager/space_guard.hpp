#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace eerie::manager {

/// Watches the disks of a campaign, so that the campaign waits for free space and does not fail
/// without it.
class SpaceGuard {
 public:
  using Clock = std::chrono::steady_clock;

  SpaceGuard(std::vector<std::filesystem::path> folders, std::uintmax_t least_free)
      : folders_(std::move(folders)), least_free_(least_free) {}

  /// Notes that a write found a disk full. The disk then counts as full for a while, each time
  /// twice as long, or until there is clearly more free space.
  void was_full(Clock::time_point now);
  /// Notes that a job has finished.
  void was_well() { patience_ = first_patience; }

  /// The reason why work has to wait; nothing where it need not.
  std::optional<std::string> complaint(Clock::time_point now);

 private:
  static constexpr std::chrono::seconds first_patience{1}, longest_patience{300};

  std::uintmax_t free_in_all() const;

  std::vector<std::filesystem::path> folders_;
  std::uintmax_t least_free_;
  Clock::time_point full_until_{};
  std::chrono::seconds patience_ = first_patience;
  bool doubted_ = false;  ///< a disk was found full since the last test
  std::uintmax_t free_when_full_ = 0;
};

/// Waits until a folder has this much free space. It calls `tell` once with the reason. Returns
/// false where a stop is requested first.
bool wait_for_room(const std::filesystem::path& folder, std::uintmax_t least_free,
                   const std::function<void(const std::string&)>& tell);

}  // namespace eerie::manager
