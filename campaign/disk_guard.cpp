#include "campaign/disk_guard.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/disk.hpp"

namespace eerie {
namespace fs = std::filesystem;

namespace {

/// What a worker needs at least to say how it ended.
constexpr std::uintmax_t probe_bytes = 1 << 20;

}  // namespace

void DiskGuard::was_full(Clock::time_point now) {
  doubted_ = true;
  full_until_ = now + patience_;
  patience_ = std::min(2 * patience_, longest_patience);
}

std::optional<std::string> DiskGuard::complaint(Clock::time_point now) {
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
  if (now < full_until_)
    return fmt::format(
        "a worker found the disk full; trying again in {} s",
        std::chrono::duration_cast<std::chrono::seconds>(full_until_ - now).count() + 1);
  doubted_ = false;
  return std::nullopt;
}

}  // namespace eerie
