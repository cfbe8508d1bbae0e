#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

/// Who may include whom; docs/architecture.md says why. Every room may include itself.
const std::map<std::string, std::set<std::string>> allowed = {
    {"solver/base", {}},
    {"solver/scene", {"solver/base"}},
    {"solver/material", {"solver/base", "solver/scene"}},
    {"solver/particles", {"solver/base"}},
    {"solver/tree", {"solver/base"}},
    {"solver/sph", {"solver/base", "solver/tree", "solver/particles", "solver/material"}},
    {"solver/io", {"solver/base", "solver/scene", "solver/particles"}},
    {"solver/step",
     {"solver/base", "solver/scene", "solver/material", "solver/particles", "solver/tree",
      "solver/sph", "solver/io", "solver/initial"}},
    {"solver/initial",
     {"solver/base", "solver/scene", "solver/material", "solver/particles", "solver/step"}},
    {"db", {}},
    {"analysis", {"solver/base", "solver/scene", "solver/particles", "solver/tree", "solver/io"}},
    {"campaign", {"db", "analysis", "solver/base", "solver/scene", "solver/io"}},
};

/// Of the campaign, only these run the solver.
const std::set<std::string> runners = {"worker.cpp",      "worker.hpp",        "result_file.cpp",
                                       "result_file.hpp", "solve_command.cpp", "split.cpp"};

std::string room_of(const fs::path& relative) {
  auto part = relative.begin();
  const std::string top = part->string();
  return top == "solver" ? top + "/" + (++part)->string() : top;
}

TEST(Layering, ArrowsBetweenFoldersPointTheWayOfTheArchitecture) {
  const fs::path root = EERIE_SOURCE_DIR;
  const std::regex include("^\\s*#include \"([^\"]+)\"");
  int read = 0;
  for (const char* top : {"solver", "db", "analysis", "campaign"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      const fs::path file = fs::relative(entry.path(), root);
      const std::string room = room_of(file);
      ASSERT_TRUE(allowed.contains(room)) << file << " is in a room that no rule knows";
      ++read;
      std::ifstream in(entry.path());
      std::smatch match;
      for (std::string line; std::getline(in, line);) {
        if (!std::regex_search(line, match, include)) continue;
        if (match[1].str().find('/') == std::string::npos) continue;  // made by the build
        const std::string other = room_of(match[1].str());
        if (other == room) continue;
        if (room == "campaign" && other == "solver/step")
          EXPECT_TRUE(runners.contains(file.filename().string())) << file << ": " << line;
        else
          EXPECT_TRUE(allowed.at(room).contains(other)) << file << ": " << line;
      }
    }
  }
  EXPECT_GT(read, 100);
}

}  // namespace
