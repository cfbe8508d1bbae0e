#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "analysis/paper/check.hpp"
#include "campaign/text/table.hpp"
#include "db/views/map_points.hpp"

namespace eerie::facts {

/// A fact and what a database says of it.
struct CheckedFact {
  const paper::Fact* fact = nullptr;
  paper::FactCheck finding;
};

struct FactReport {
  std::filesystem::path database;
  std::vector<CheckedFact> facts;
  std::string remark;                          ///< on unsettled results and those not used
  std::vector<std::filesystem::path> figures;  ///< maps, beside the report
  std::string no_figures;                      ///< why there are none

  std::size_t count(paper::Agreement agreement) const;
};

/// Every fact of the paper against the results of a database, of these settings where given.
FactReport check_facts(const db::Connection& connection, const db::MapFilter& settings);

/// Draws the maps beside `file`, "FILE-q1-phi40-n1000.svg"; without gnuplot the report says so.
void draw_maps(FactReport& report, const db::Connection& connection, const db::MapFilter& settings,
               const std::filesystem::path& file);

nlohmann::json to_json(const FactReport& report);
/// For people: fact, verdict, what is found and on what that rests.
text::Table table_of_facts(const FactReport& report);
/// The whole as a page of Markdown; figures are named relative to it.
std::string markdown(const FactReport& report);

/// Each command that would decide something, with the facts that wait for it, in their order.
std::vector<std::pair<std::string, std::string>> commands_of(const FactReport& report);
/// "23 facts: 12 agrees, ..."
std::string summary(const FactReport& report);
/// By what rules facts are decided, and where others are.
std::string rules();
inline constexpr const char* other_means =
    "Facts on the disk around the impacts, on friction and on tides are checked by `eerie disk`.";

}  // namespace eerie::facts
