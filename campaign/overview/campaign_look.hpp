#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/manager/manager.hpp"
#include "campaign/manager/silence.hpp"
#include "campaign/text/table.hpp"
#include "db/views/query.hpp"

namespace eerie::overview {

/// The state of a campaign at one moment.
struct CampaignLook {
  std::vector<db::SweepStatus> sweeps;
  std::vector<db::FailureGroup> failures;
  db::Speed speed;
  std::optional<std::string> holder;
  std::optional<manager::CampaignView> at_work;  ///< reported by the manager
  std::vector<manager::Silence> silent;
  job_folder::JobFolder folder;
  /// Found here, since a manager on a full disk cannot report it.
  std::optional<std::string> no_room = {};
};

CampaignLook look_at(const std::filesystem::path& database);

/// {"database", "worked_on_by", "sweeps": [{"name", "created", "jobs", "core_hours_left"}],
///  "failures", "silent", "no_room"}, with "at_work" where a manager is.
nlohmann::json to_json(const CampaignLook& look, const std::filesystem::path& database);

/// [{"kind", "jobs", "hash", "message"}].
nlohmann::json to_json(const std::vector<db::FailureGroup>& failures);

/// A table with one row per sweep, for people.
text::Table table_of_sweeps(const CampaignLook& look);

}  // namespace eerie::overview
