#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/paper/check.hpp"
#include "campaign/maps/impact_runs.hpp"

namespace eerie::cli {

/// A fact and what a database says of it.
struct CheckedFact {
  const paper::Fact* fact = nullptr;
  paper::FactCheck finding;
};

struct CheckReport {
  std::filesystem::path database;
  std::vector<CheckedFact> facts;
  std::string remark;                          ///< on unsettled results and those not used
  std::vector<std::filesystem::path> figures;  ///< maps, beside the report
  std::string no_figures;                      ///< why there are none

  std::size_t count(paper::Agreement agreement) const;
};

// What `eerie check` prints and writes.

nlohmann::json to_json(const CheckReport& report);
/// A table, what disagrees, and the commands that would decide the rest.
std::string check_text(const CheckReport& report);
/// The same for readers, with the maps; figures are named relative to the report.
std::string check_markdown(const CheckReport& report);

}  // namespace eerie::cli
