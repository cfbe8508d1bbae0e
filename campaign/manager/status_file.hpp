#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "campaign/manager/manager.hpp"

namespace eerie::manager {

/// The file "<database>.status.json", in which the manager at work reports to `eerie status`. No
/// decision depends on it.
class StatusFile {
 public:
  explicit StatusFile(const std::filesystem::path& database);
  ~StatusFile();
  StatusFile(const StatusFile&) = delete;
  StatusFile& operator=(const StatusFile&) = delete;

  /// Writes the file, at most every few seconds and only after a change.
  void show(const CampaignView& view);

 private:
  std::filesystem::path path_;
  std::string written_;
  std::chrono::steady_clock::time_point next_{};
};

/// The last view that a manager wrote; nothing where there is none. It has no counts of jobs, since
/// the database has them.
std::optional<CampaignView> read_status_file(const std::filesystem::path& database);

}  // namespace eerie::manager
