#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>

#include "tests/support/sources.hpp"

namespace {

using Rooms = std::set<std::string>;

/// Who may include whom, besides solver/base, which everyone may, and solver/scene, which everyone
/// in analysis and campaign may; docs/architecture.md says why. A room may include itself.
const std::map<std::string, Rooms> allowed = {
    {"solver/base", {}},
    {"solver/scene", {}},
    {"solver/material", {"solver/scene"}},
    {"solver/particles", {}},
    {"solver/tree", {}},
    {"solver/sph", {"solver/tree", "solver/particles", "solver/material"}},
    {"solver/io", {"solver/scene", "solver/particles"}},
    {"solver/step",
     {"solver/scene", "solver/material", "solver/particles", "solver/tree", "solver/sph",
      "solver/io"}},
    {"solver/initial",
     {"solver/scene", "solver/material", "solver/particles", "solver/io", "solver/step"}},
    {"solver/run",
     {"solver/scene", "solver/particles", "solver/io", "solver/step", "solver/initial"}},

    {"db/store", {}},
    {"db/jobs", {"db/store"}},
    {"db/views", {"db/store", "db/jobs"}},

    {"analysis/statistics", {}},
    {"analysis/shapes", {"solver/io", "solver/particles"}},
    {"analysis/remnants", {"analysis/shapes", "solver/io", "solver/particles"}},
    {"analysis/flight", {"analysis/remnants", "solver/particles", "solver/tree"}},
    {"analysis/ending", {"analysis/flight", "analysis/remnants", "solver/io", "solver/particles"}},
    {"analysis/paper", {"analysis/remnants", "analysis/statistics"}},
    {"analysis/drawing", {"analysis/remnants"}},
    {"analysis/diagrams", {"analysis/drawing", "analysis/remnants", "analysis/statistics"}},
    {"analysis/figures", {"analysis/drawing", "analysis/remnants"}},
    {"analysis/disk", {"analysis/drawing"}},
    {"analysis/light_curve",
     {"analysis/drawing", "analysis/remnants", "analysis/shapes", "solver/io", "solver/particles"}},
    {"analysis/pictures",
     {"analysis/drawing", "analysis/remnants", "analysis/shapes", "solver/io"}},

    {"campaign/text", {}},
    {"campaign/manual", {"campaign/text"}},
    {"campaign/process", {}},
    {"campaign/sweeps", {"campaign/text", "db/store", "db/jobs", "solver/initial"}},
    {"campaign/job_folder",
     {"campaign/text", "db/store", "db/jobs", "analysis/remnants", "analysis/ending", "solver/io",
      "solver/run"}},
    {"campaign/worker",
     {"campaign/job_folder", "campaign/process", "campaign/sweeps", "campaign/text", "db/store",
      "db/jobs", "analysis/remnants", "analysis/ending", "solver/io", "solver/run", "solver/step"}},
    // Never the worker, and so never what moves particles.
    {"campaign/manager",
     {"campaign/job_folder", "campaign/process", "campaign/sweeps", "campaign/text", "db/store",
      "db/jobs", "db/views", "solver/io", "solver/run"}},
    {"campaign/comparison",
     {"campaign/text", "db/store", "db/jobs", "db/views", "analysis/statistics"}},
    {"campaign/merging", {"campaign/job_folder", "campaign/text", "db/store", "db/jobs"}},
    {"campaign/slurm",
     {"campaign/manager", "campaign/job_folder", "campaign/process", "campaign/text"}},
    {"campaign/results",
     {"campaign/job_folder", "campaign/text", "analysis/figures", "db/store", "db/jobs", "db/views",
      "analysis/remnants", "analysis/statistics"}},
    {"campaign/studies",
     {"campaign/results", "campaign/manager", "campaign/process", "campaign/sweeps",
      "campaign/job_folder", "campaign/text", "db/store", "db/jobs", "db/views", "analysis/figures",
      "analysis/remnants", "analysis/statistics"}},
    {"campaign/auto_fidelity",
     {"campaign/results", "campaign/manager", "campaign/process", "campaign/sweeps",
      "campaign/text", "db/store", "db/jobs", "db/views", "analysis/remnants",
      "analysis/statistics", "analysis/paper", "analysis/diagrams"}},
    {"campaign/maps",
     {"campaign/results", "campaign/sweeps", "campaign/text", "db/store", "db/jobs", "db/views",
      "analysis/paper", "analysis/remnants", "analysis/statistics", "analysis/diagrams"}},
    // The dashboard reads all and runs nothing.
    {"campaign/serve",
     {"campaign/manager", "campaign/maps", "campaign/queries", "campaign/results",
      "campaign/job_folder", "campaign/sweeps", "campaign/text", "db/store", "db/jobs", "db/views",
      "analysis/diagrams", "analysis/drawing", "analysis/paper", "analysis/pictures",
      "analysis/remnants", "analysis/shapes", "analysis/statistics", "solver/io",
      "solver/particles"}},
    {"campaign/catalogue",
     {"campaign/sweeps", "campaign/text", "db/store", "db/jobs", "db/views", "analysis/paper",
      "analysis/remnants", "analysis/statistics"}},
    {"campaign/overview",
     {"campaign/manager", "campaign/job_folder", "campaign/sweeps", "campaign/text", "db/store",
      "db/jobs", "db/views"}},
    {"campaign/queries",
     {"campaign/job_folder", "campaign/sweeps", "campaign/text", "db/store", "db/jobs", "db/views",
      "analysis/remnants"}},
    {"campaign/facts",
     {"campaign/maps", "campaign/text", "db/store", "db/views", "analysis/paper",
      "analysis/remnants", "analysis/diagrams"}},
    {"campaign/surroundings", {"campaign/text", "db/views", "analysis/disk", "analysis/figures"}},
    {"campaign/run_pictures",
     {"campaign/job_folder", "campaign/text", "analysis/drawing", "analysis/pictures",
      "analysis/remnants", "solver/io"}},
};

/// The command line and main() may include all but the insides of the solver.
const Rooms closed_to_commands = {"solver/material", "solver/particles", "solver/tree",
                                  "solver/sph",      "solver/initial",   "solver/step"};

bool may_include(const std::string& room, const std::string& other) {
  if (other == room || other == "solver/base") return true;
  if (room == "campaign/cli" || room == "campaign") return !closed_to_commands.contains(other);
  if (other == "solver/scene" && !room.starts_with("solver/") && !room.starts_with("db/"))
    return true;
  return allowed.at(room).contains(other);
}

/// Which rooms each room includes, itself left out.
using Arrows = std::map<std::string, Rooms>;

struct Included {
  std::string from, other;
  std::string line;
};

std::vector<Included> includes() {
  const std::regex include("^\\s*#include \"([^\"]+/[^\"]+)\"");
  std::vector<Included> found;
  for (const auto& file : eerie::test::source_files({"solver", "db", "analysis", "campaign"})) {
    std::smatch match;
    for (const std::string& line : file.lines) {
      if (!std::regex_search(line, match, include)) continue;
      const std::filesystem::path other = match[1].str();
      auto part = other.begin();
      const std::string top = part->string();
      found.push_back(
          {file.room, top + "/" + (++part)->string(), file.path.string() + ": " + line});
    }
  }
  return found;
}

/// A room that can be reached from itself; empty where there is none.
std::string room_on_a_circle(const Arrows& arrows) {
  for (const auto& [start, first] : arrows) {
    Rooms reached = first, edge = first;
    while (!edge.empty()) {
      Rooms next;
      for (const std::string& room : edge)
        if (const auto on = arrows.find(room); on != arrows.end())
          for (const std::string& other : on->second)
            if (reached.insert(other).second) next.insert(other);
      edge = std::move(next);
    }
    if (reached.contains(start)) return start;
  }
  return "";
}

TEST(Layering, ArrowsBetweenRoomsPointTheWayOfTheArchitecture) {
  const std::vector<Included> all = includes();
  ASSERT_GT(all.size(), 500u);
  for (const Included& one : all) {
    ASSERT_TRUE(allowed.contains(one.from) || one.from == "campaign/cli" || one.from == "campaign")
        << one.from << " is a room that no rule knows: " << one.line;
    EXPECT_TRUE(may_include(one.from, one.other)) << one.line;
  }
}

TEST(Layering, NoRoomReachesItselfThroughOthers) {
  Arrows arrows;
  for (const Included& one : includes())
    if (one.from != one.other) arrows[one.from].insert(one.other);
  EXPECT_EQ(room_on_a_circle(arrows), "");
  arrows["solver/base"].insert("campaign/cli");
  EXPECT_NE(room_on_a_circle(arrows), "");
}

TEST(Layering, NoFolderHoldsMoreThanTwentyFiveFilesAndNoFileMoreThanFourHundredLines) {
  std::map<std::string, int> count;
  for (const auto& file : eerie::test::source_files({"solver", "db", "analysis", "campaign"})) {
    ++count[file.path.parent_path().string()];
    EXPECT_LE(file.lines.size(), 400u) << file.path;
  }
  for (const auto& [folder, files] : count) EXPECT_LE(files, 25) << folder;
}

}  // namespace
