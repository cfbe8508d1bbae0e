#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>

#include "tests/support/sources.hpp"

namespace {

/// Types that a file defines at the level of a namespace: "eerie::manager::Manager". Those of
/// unnamed namespaces are nobody else's.
std::vector<std::string> types_of(const eerie::test::SourceFile& file) {
  static const std::regex opens("^(?:inline )?namespace (eerie[A-Za-z_:0-9]*) \\{"),
      closes("^\\}  // namespace (eerie[A-Za-z_:0-9]*)$"),
      defines("^(?:struct|class|enum class|enum) ([A-Za-z0-9_]+)(?: final)?(?: :[^:].*)? \\{"),
      aliases("^using ([A-Za-z0-9_]+) =");
  std::vector<std::string> types;
  std::string space;
  bool unnamed = false;
  std::smatch match;
  for (const std::string& line : file.lines) {
    if (std::regex_search(line, match, opens)) space = match[1];
    if (std::regex_search(line, match, closes)) space.clear();
    if (line == "namespace {") unnamed = true;
    if (line == "}  // namespace") unnamed = false;
    if (unnamed || space.empty()) continue;
    if (std::regex_search(line, match, defines) || std::regex_search(line, match, aliases))
      types.push_back(space + "::" + match[1].str());
  }
  return types;
}

// Two types of one name in one binary are undefined behaviour that no compiler reports: the linker
// keeps one of their functions.
TEST(Names, NoTwoFilesDefineATypeOfTheSameName) {
  std::map<std::string, std::string> defined;
  for (const auto& file : eerie::test::source_files({"solver", "db", "analysis", "campaign"}))
    for (const std::string& type : types_of(file)) {
      const auto [known, is_new] = defined.emplace(type, file.path.string());
      EXPECT_TRUE(is_new) << type << " is defined in " << known->second << " and in " << file.path;
    }
  EXPECT_GT(defined.size(), 300u);
}

TEST(Names, EveryRoomHasItsOwnNamespace) {
  std::map<std::string, std::set<std::string>> rooms;  // of each namespace
  const std::regex opens("^namespace (eerie[A-Za-z_:0-9]*) \\{");
  for (const auto& file : eerie::test::source_files({"solver", "db", "analysis", "campaign"})) {
    std::smatch match;
    for (const std::string& line : file.lines)
      if (std::regex_search(line, match, opens)) rooms[match[1]].insert(file.room);
  }
  // What everyone speaks: vectors, errors, files, the scene.
  EXPECT_EQ(rooms["eerie"], (std::set<std::string>{"solver/base", "solver/scene"}));
  // A library of one kind: what keeps the database.
  EXPECT_EQ(rooms["eerie::db"], (std::set<std::string>{"db/jobs", "db/store", "db/views"}));
  for (const auto& [space, in] : rooms)
    if (space != "eerie" && space != "eerie::db") {
      ASSERT_EQ(in.size(), 1u) << space;
      const std::string inner = space.substr(7), room = *in.begin();
      EXPECT_EQ(room.substr(room.find('/') + 1), inner.substr(0, inner.find(':'))) << room;
    }
}

}  // namespace
