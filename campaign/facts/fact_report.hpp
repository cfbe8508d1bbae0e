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

/// A fact and its test against a database.
struct CheckedFact {
  const paper::Fact* fact = nullptr;
  paper::FactCheck finding;
};

struct FactReport {
  std::filesystem::path database;
  std::vector<CheckedFact> facts;
  std::string remark;  ///< about unsettled results and those that are not used
  std::vector<std::filesystem::path> figures;  ///< maps beside the report
  std::string no_figures;                      ///< the reason where there are none

  std::size_t count(paper::Agreement agreement) const;
};

/// Tests every fact of the paper against the results of a database, of these settings where given.
FactReport check_facts(const db::Connection& connection, const db::MapFilter& settings);

/// Draws the maps beside `file`, "FILE-q1-phi40-n1000.svg". Without gnuplot the report says why
/// there are none.
void draw_maps(FactReport& report, const db::Connection& connection, const db::MapFilter& settings,
               const std::filesystem::path& file);

nlohmann::json to_json(const FactReport& report);
/// A table for people: each fact, its verdict, the finding, and the runs behind it.
text::Table table_of_facts(const FactReport& report);
/// The whole report as a page of Markdown. Paths of figures are relative to it.
std::string markdown(const FactReport& report);

/// Each command that would decide some facts, with the names of these facts, in their order.
std::vector<std::pair<std::string, std::string>> commands_of(const FactReport& report);
/// The counts, "23 facts: 12 agrees, ..."
std::string summary(const FactReport& report);
/// The rules by which facts are decided.
std::string rules();
inline constexpr const char* other_means =
    "Facts on the disk around the impacts, on friction and on tides are checked by `eerie disk`.";

}  // namespace eerie::facts
