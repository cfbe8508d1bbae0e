#include "tests/proof/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <regex>
#include <utility>

#include "campaign/text/csv.hpp"

namespace eerie::proof {
using nlohmann::json;

namespace {

bool is_check(const json& block) { return block["kind"] == "check"; }
bool is_note(const json& block) { return block["kind"] == "note"; }
bool holds(const json& check) { return check["passed"].get<bool>(); }

std::string text_of(const json& block, const char* key) { return block[key].get<std::string>(); }

/// From the value to its nearest bound, as a share of what is allowed. A lower bound of 0 is that
/// of a size, and no size is the worse for being small; what must be exact has no room to be near
/// to.
double room(const json& check) {
  const double value = check["value"], lo = check["lo"], hi = check["hi"];
  if (lo == hi) return std::numeric_limits<double>::max();
  return (lo == 0 ? hi - value : std::min(value - lo, hi - value)) / (hi - lo);
}

std::vector<json> filtered(const json& record, bool (*wanted)(const json&)) {
  std::vector<json> found;
  for (const json& block : record["blocks"])
    if (wanted(block)) found.push_back(block);
  return found;
}

/// Whether check `k` is one of three and more that hold for one reason, and another of them is
/// nearer to its bounds; of equals the first is.
bool is_left_out(const std::vector<json>& checks, std::size_t k) {
  std::size_t of_a_kind = 0, nearer = 0;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    if (!holds(checks[i]) || checks[i]["reason"] != checks[k]["reason"]) continue;
    ++of_a_kind;
    nearer += std::pair(room(checks[i]), i) < std::pair(room(checks[k]), k);
  }
  return of_a_kind > 2 && nearer > 0;
}

/// A quantity is named "period, h": without what follows the last comma where that is a unit.
std::pair<std::string, std::string> name_and_unit(const std::string& what) {
  const std::size_t comma = what.rfind(", ");
  if (comma != std::string::npos)
    for (const char* unit : {"h", "s", "m", "L0", "spacings"})
      if (what.substr(comma + 2) == unit) return {what.substr(0, comma), unit};
  return {what, "1"};
}

/// "0.93–1"; a size has no lower bound that says anything.
std::string allowed(const json& check) {
  const double lo = check["lo"], hi = check["hi"];
  if (lo == hi) return fmt::format("{:.4g}", lo);
  if (lo == 0) return fmt::format("≤ {:.4g}", hi);
  if (lo == -hi) return fmt::format("±{:.4g}", hi);
  return fmt::format("{:.4g}{}{:.4g}", lo, lo < 0 ? " to " : "–", hi);
}

/// `reason` is the last that the table gave, and becomes that of this line where it has one.
std::string last_cell(const json& block, std::string& reason) {
  const bool check = is_check(block);
  if (check && holds(block)) return allowed(block);
  static const std::regex range("^([0-9.]+) to ([0-9.]+)$");
  std::string cell =
      check ? allowed(block) : std::regex_replace(text_of(block, "wish"), range, "$1–$2");
  cell += fmt::format("{}{}", cell.empty() ? "" : ", ", check ? "**not held**" : "*noted*");
  const std::string why = text_of(block, "reason");
  if (why.empty()) return cell;
  return cell + ": " + (std::exchange(reason, why) == why ? "as above" : why);
}

std::string table_of_lines(const json& record) {
  const std::vector<json> lines = shown_lines(record), checks = filtered(record, is_check);
  if (lines.empty()) return "";
  std::string out = "| quantity | measured | allowed |\n|---|---|---|\n", reason;
  for (const json& line : lines)
    out += fmt::format("| {} | {:.4g} | {} |\n", text_of(line, "what"), line["value"].get<double>(),
                       last_cell(line, reason));
  if (std::ranges::count_if(lines, is_check) < std::ssize(checks))
    out += fmt::format("\n{} of {} hold; the rest in the CSV.\n",
                       std::ranges::count_if(checks, holds), checks.size());
  return out + "\n";
}

std::string row_of(const json& cells) {
  std::string row = "|";
  for (const json& cell : cells) row += " " + cell.get<std::string>() + " |";
  return row + "\n";
}

std::string table_of_rows(const json& block) {
  std::string out = row_of(block["head"]) + "|";
  for (std::size_t k = 0; k < block["head"].size(); ++k) out += "---|";
  out += "\n";
  for (const json& row : block["rows"]) out += row_of(row);
  return out + "\n";
}

std::string without_ending(const std::string& file) { return file.substr(0, file.rfind('.')); }

/// The caption is what all readers see, so the picture's own text does not repeat it.
std::string figure_of(const json& block, const std::string& folder, const std::string& numbers) {
  const std::string file = text_of(block, "file");
  return fmt::format("![{}]({}{})\n\n*{}*{}\n\n", without_ending(file), folder, file,
                     text_of(block, "caption"),
                     numbers.empty() ? "" : fmt::format(" ([numbers]({}{}))", folder, numbers));
}

std::string section(const json& record, const std::string& page) {
  std::string out =
      fmt::format("\n## {}\n\n{}\n\n", text_of(record, "title"), text_of(record, "text"));
  std::string numbers = numbers_of(record).first, after;
  const bool on_the_page = numbers.empty();
  for (const json& block : record["blocks"]) {
    if (block["kind"] == "figure")
      out += figure_of(block, "figures/" + page + "/", std::exchange(numbers, ""));
    if (block["kind"] == "text") after += text_of(block, "text") + "\n\n";
    if (block["kind"] == "table" && on_the_page) after += table_of_rows(block);
  }
  out += table_of_lines(record) + after;
  out.pop_back();
  return out;
}

/// "5" where all hold, else "**4 of 5**".
std::string held_of(const std::vector<json>& checks) {
  const auto held = std::ranges::count_if(checks, holds);
  return held == std::ssize(checks) ? std::to_string(held)
                                    : fmt::format("**{} of {}**", held, checks.size());
}

/// One line for each entry: how many of its checks hold, and what is noted.
std::string summary(const std::vector<json>& records) {
  std::string out = "\n| entry | checks held | noted |\n|---|---|---|\n";
  for (const json& record : records) {
    const std::vector<json> checks = filtered(record, is_check);
    const std::size_t notes = filtered(record, is_note).size();
    out += fmt::format("| {} | {} | {} |\n", text_of(record, "title"), held_of(checks),
                       notes == 0 ? "" : std::to_string(notes));
  }
  return out;
}

std::string answer(const std::vector<json>& records) {
  std::string failures;
  for (const json& record : records)
    if (!record["passed"].get<bool>())
      failures += (failures.empty() ? "" : "; ") + text_of(record, "title");
  return failures.empty() ? fmt::format("All {} entries are within their bounds.", records.size())
                          : fmt::format("**Out of bounds:** {}.", failures);
}

}  // namespace

std::vector<json> shown_lines(const json& record) {
  const std::vector<json> checks = filtered(record, is_check);
  std::vector<json> lines;
  for (std::size_t k = 0; k < checks.size(); ++k)
    if (!holds(checks[k]) || !is_left_out(checks, k)) lines.push_back(checks[k]);
  std::ranges::move(filtered(record, is_note), std::back_inserter(lines));
  return lines;
}

std::pair<std::string, std::string> numbers_of(const json& record) {
  const auto is_figure = [](const json& block) { return block["kind"] == "figure"; };
  const auto is_table = [](const json& block) { return block["kind"] == "table"; };
  const std::vector<json> figures = filtered(record, is_figure),
                          tables = filtered(record, is_table);
  if (figures.empty() || tables.size() != 1) return {};
  const auto line = [](const json& cells) {
    std::vector<std::string> fields;
    for (const json& cell : cells) fields.push_back(text::csv_field(cell.get<std::string>()));
    return fmt::format("{}\n", fmt::join(fields, ","));
  };
  std::string csv = line(tables[0]["head"]);
  for (const json& row : tables[0]["rows"]) csv += line(row);
  return {without_ending(text_of(figures[0], "file")) + ".csv", csv};
}

std::string markdown_page(const Page& page, const std::vector<json>& records) {
  std::string out =
      fmt::format("{}\n\n**Answer.** {}\n\n{}\n", page.head, answer(records), page.preamble) +
      summary(records);
  for (const json& record : records) out += section(record, page.name);
  return out;
}

std::string checks_csv(const std::vector<json>& records) {
  using text::csv_field, text::csv_number;
  std::string out = "entry,quantity,measured,unit,allowed_from,allowed_to,wished,holds,reason\n";
  for (const json& record : records)
    for (const json& block : record["blocks"]) {
      const bool check = is_check(block);
      if (!check && !is_note(block)) continue;
      const auto [name, unit] = name_and_unit(text_of(block, "what"));
      out += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_field(text_of(record, "title")),
                         csv_field(name), csv_number(block["value"].get<double>()), csv_field(unit),
                         check ? csv_number(block["lo"].get<double>()) : "",
                         check ? csv_number(block["hi"].get<double>()) : "",
                         check ? "" : csv_field(text_of(block, "wish")),
                         !check         ? "noted"
                         : holds(block) ? "yes"
                                        : "no",
                         csv_field(text_of(block, "reason")));
    }
  return out;
}

}  // namespace eerie::proof
