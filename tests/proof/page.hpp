#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

// Pages of the notebook, from what Record wrote.

namespace eerie::proof {

/// A page that is made from records: its file without ending, what stands above its answer, and
/// what stands between the answer and the entries.
struct Page {
  std::string name, head, preamble;
};

/// The blocks of a record that its page shows as lines of a table: first the checks, then all that
/// is noted. Of three and more checks that hold for one reason only the one nearest to its bounds
/// is among them; each that fails is.
std::vector<nlohmann::json> shown_lines(const nlohmann::json& record);

/// The table of an entry that has a figure as well stands beside it: the name of its CSV file,
/// after that of the first figure, and its text. Both are empty where there is no such table.
std::pair<std::string, std::string> numbers_of(const nlohmann::json& record);

/// The page in Markdown; `records` in the order of its entries.
std::string markdown_page(const Page& page, const std::vector<nlohmann::json>& records);

/// Every check and everything noted, a row each, as CSV with a head (RFC 4180; lines end in LF).
/// A bound that a row lacks is empty; the unit of a pure number is 1.
std::string checks_csv(const std::vector<nlohmann::json>& records);

}  // namespace eerie::proof
