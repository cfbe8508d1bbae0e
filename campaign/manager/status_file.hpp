#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "campaign/manager/manager.hpp"

namespace eerie::manager {

/// "<database>.status.json": what the manager at work says of itself to `eerie status`. A
/// convenience: nothing is decided by it.
class StatusFile {
 public:
  explicit StatusFile(const std::filesystem::path& database);
  ~StatusFile();
  StatusFile(const StatusFile&) = delete;
  StatusFile& operator=(const StatusFile&) = delete;

  /// Writes it, every few seconds at most and where something has changed.
  void show(const CampaignView& view);

 private:
  std::filesystem::path path_;
  std::string written_;
  std::chrono::steady_clock::time_point next_{};
};

/// The last view that a manager wrote; nothing where it wrote none. Counts of jobs are not in it:
/// the database has them.
std::optional<CampaignView> read_status_file(const std::filesystem::path& database);

}  // namespace eerie::manager
