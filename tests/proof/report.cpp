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
     "# What is proven, and how well\n\nMade by `make validate`; do not edit. Each entry is a "
     "test: "
     "it says what is compared with what, what came out, which values are allowed and why. Entries "
     "marked *noted* are results that one would wish otherwise; they are said, not hidden. Quick "
     "forms of the proofs run in `make test`.\n"},
    {"stability",
     "# Where methods fail\n\nMade by `make validate`; do not edit. For each knob of the method: "
     "what breaks first when it is turned too far, how that shows, where the default stands and "
     "with what margin. A scene that crosses one of these lines is refused, or runs with a warning "
     "(`solver/scene/guards.cpp`).\n"}};

std::string line_of(const json& block) {
  if (block["kind"] == "check")
    return fmt::format(
        "| {} | {:.4g} | {:.4g} to {:.4g} | {} | {} |\n", block["what"].get<std::string>(),
        block["value"].get<double>(), block["lo"].get<double>(), block["hi"].get<double>(),
        block["passed"].get<bool>() ? "yes" : "**no**", block["reason"].get<std::string>());
  return fmt::format("| {} | {:.4g} | {} | *noted* | {} |\n", block["what"].get<std::string>(),
                     block["value"].get<double>(), block["wish"].get<std::string>(),
                     block["reason"].get<std::string>());
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
  for (const json& block : record["blocks"]) {
    const std::string kind = block["kind"];
    const bool is_line = kind == "check" || kind == "note";
    if (is_line && !in_checks)
      out += "| quantity | measured | allowed | holds | reason |\n|---|---|---|---|---|\n";
    if (!is_line && in_checks) out += "\n";
    in_checks = is_line;
    if (is_line) out += line_of(block);
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
    std::string text = page.preamble, failures;
    for (const json& record : found)
      if (!record["passed"].get<bool>())
        failures += fmt::format("- {}\n", record["title"].get<std::string>());
    text += failures.empty()
                ? fmt::format("\nAll {} entries are within their bounds.\n", found.size())
                : fmt::format("\n**Out of bounds:**\n\n{}", failures);
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
