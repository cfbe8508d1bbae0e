#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "solver/base/file.hpp"
#include "tests/proof/page.hpp"

// Turns the records of `make validate` into docs/notebook/validation.md and
// docs/notebook/stability.md, each with the CSV of its checks and its figures beside it; tables of
// figures are CSV beside these.
// usage: eerie_report RECORDS DOCS

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

const eerie::proof::Page pages[] = {
    {"validation",
     "# What is proven, and how well?\n\n**Question.** Does the solver solve its equations, and do "
     "impacts come out as published?",
     "Made by `make validate`; do not edit. Each entry is a test. All checks with unit and reason: "
     "[validation.csv](validation.csv). Of three and more that hold for one reason, only the one "
     "nearest to its bounds is shown here. What is *noted* one would wish otherwise. Quick forms "
     "of the proofs run in `make test`."},
    {"stability",
     "# Where do methods fail?\n\n**Question.** Which knob of the method breaks what, and how far "
     "from that is the default?",
     "Made by `make validate`; do not edit. For each knob: what breaks first when it is turned too "
     "far. Unless said otherwise, the run is the reference impact with 500 particles per target, "
     "to 4,000 s. All checks with unit and reason: [stability.csv](stability.csv). What is *noted* "
     "one would wish otherwise. A scene that crosses one of these lines is refused, or runs with a "
     "warning (`solver/scene/guards.cpp`)."}};

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
  for (const eerie::proof::Page& page : pages) {
    auto& found = by_page[page.name];
    std::ranges::sort(found, {}, [](const json& record) {
      return std::pair(record["order"].get<int>(), record["title"].get<std::string>());
    });
    const fs::path figures = docs / "figures" / page.name;
    fs::create_directories(figures);
    for (const json& record : found) {
      for (const json& block : record["blocks"])
        if (block["kind"] == "figure")
          fs::copy_file(records / block["file"].get<std::string>(),
                        figures / block["file"].get<std::string>(),
                        fs::copy_options::overwrite_existing);
      const auto [name, numbers] = eerie::proof::numbers_of(record);
      if (!name.empty()) eerie::install_text(figures / name, numbers);
    }
    eerie::install_text(docs / (page.name + ".csv"), eerie::proof::checks_csv(found));
    eerie::install_text(docs / (page.name + ".md"), eerie::proof::markdown_page(page, found));
    std::printf("%s: %zu entries\n", (docs / (page.name + ".md")).c_str(), found.size());
  }
  return 0;
}
