#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "solver/base/file.hpp"

// Turns the records of `make validate` into docs/notebook/validation.md and
// docs/notebook/stability.md. usage: eerie_report RECORDS DOCS

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Page {
  std::string name, preamble;
};
const Page pages[] = {
    {"validation",
     "# What is proven, and how well?\n\n**Question.** Does the solver solve its equations, and do "
     "impacts come out as published?\n\n**Answer.** {}\n\nMade by `make validate`; do not edit. "
     "Each entry is a test: what is compared with what, what came out, which values are allowed "
     "and why. What is *noted* one would wish otherwise. Quick forms of the proofs run in `make "
     "test`.\n"},
    {"stability",
     "# Where do methods fail?\n\n**Question.** Which knob of the method breaks what, and how far "
     "from that is the default?\n\n**Answer.** {}\n\nMade by `make validate`; do not edit. For "
     "each knob: what breaks first when it is turned too far, and how that shows. A scene that "
     "crosses one of these lines is refused, or runs with a warning "
     "(`solver/scene/guards.cpp`).\n"}};

/// `reason` is that of the line before, and becomes that of this one.
std::string line_of(const json& block, std::string& reason) {
  const bool same = block["reason"] == reason && !reason.empty();
  reason = block["reason"];
  const std::string shown = same ? "as above" : reason;
  if (block["kind"] == "check")
    return fmt::format("| {} | {:.4g} | {:.4g} to {:.4g} | {} | {} |\n",
                       block["what"].get<std::string>(), block["value"].get<double>(),
                       block["lo"].get<double>(), block["hi"].get<double>(),
                       block["passed"].get<bool>() ? "yes" : "**no**", shown);
  return fmt::format("| {} | {:.4g} | {} | *noted* | {} |\n", block["what"].get<std::string>(),
                     block["value"].get<double>(), block["wish"].get<std::string>(), shown);
}

/// One line for each entry: how many of its checks hold, and what is noted.
std::string summary(const std::vector<json>& records) {
  std::string out = "\n| entry | checks that hold | noted |\n|---|---|---|\n";
  for (const json& record : records) {
    int checks = 0, held = 0, notes = 0;
    for (const json& block : record["blocks"]) {
      if (block["kind"] == "note") ++notes;
      if (block["kind"] != "check") continue;
      ++checks;
      if (block["passed"].get<bool>()) ++held;
    }
    out += fmt::format("| {} | {} of {} | {} |\n", record["title"].get<std::string>(), held, checks,
                       notes == 0 ? "" : std::to_string(notes));
  }
  return out;
}

std::string row_of(const json& cells) {
  std::string row = "|";
  for (const json& cell : cells) row += " " + cell.get<std::string>() + " |";
  return row + "\n";
}

std::string section(const json& record, const std::string& page) {
  std::string out = fmt::format("\n## {}\n\n{}\n\n", record["title"].get<std::string>(),
                                record["text"].get<std::string>());
  bool in_checks = false;
  std::string reason;
  for (const json& block : record["blocks"]) {
    const std::string kind = block["kind"];
    const bool is_line = kind == "check" || kind == "note";
    if (is_line && !in_checks)
      out += "| quantity | measured | allowed | holds | reason |\n|---|---|---|---|---|\n";
    if (!is_line && in_checks) out += "\n";
    in_checks = is_line;
    if (!is_line) reason.clear();
    if (is_line) out += line_of(block, reason);
    if (kind == "text") out += block["text"].get<std::string>() + "\n\n";
    if (kind == "figure")
      out +=
          fmt::format("![{0}](figures/{1}/{2})\n\n*{0}*\n\n", block["caption"].get<std::string>(),
                      page, block["file"].get<std::string>());
    if (kind == "table") {
      out += row_of(block["head"]) + "|";
      for (std::size_t k = 0; k < block["head"].size(); ++k) out += "---|";
      out += "\n";
      for (const json& row : block["rows"]) out += row_of(row);
      out += "\n";
    }
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: eerie_report RECORDS DOCS\n");
    return 2;
  }
  const fs::path records = argv[1], docs = argv[2];
  std::map<std::string, std::vector<json>> by_page;
  for (const auto& entry : fs::directory_iterator(records))
    if (entry.path().extension() == ".json") {
      json record = json::parse(eerie::read_file(entry.path()));
      by_page[record["page"]].push_back(std::move(record));
    }
  for (const Page& page : pages) {
    auto& found = by_page[page.name];
    std::sort(found.begin(), found.end(),
              [](const json& a, const json& b) { return a["order"] < b["order"]; });
    std::string failures;
    for (const json& record : found)
      if (!record["passed"].get<bool>())
        failures += (failures.empty() ? "" : "; ") + record["title"].get<std::string>();
    const std::string answer =
        failures.empty() ? fmt::format("All {} entries are within their bounds.", found.size())
                         : fmt::format("**Out of bounds:** {}.", failures);
    std::string text = fmt::format(fmt::runtime(page.preamble), answer) + summary(found);
    const fs::path figures = docs / "figures" / page.name;
    fs::create_directories(figures);
    for (const json& record : found) {
      text += section(record, page.name);
      for (const json& block : record["blocks"])
        if (block["kind"] == "figure")
          fs::copy_file(records / block["file"].get<std::string>(),
                        figures / block["file"].get<std::string>(),
                        fs::copy_options::overwrite_existing);
    }
    eerie::install_text(docs / (page.name + ".md"), text);
    std::printf("%s: %zu entries\n", (docs / (page.name + ".md")).c_str(), found.size());
  }
  return 0;
}
