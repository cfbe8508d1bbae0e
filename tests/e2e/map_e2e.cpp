#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "solver/base/file.hpp"
#include "tests/support/impact_database.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using test::survey_scene;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
namespace fs = std::filesystem;

/// Surveys at two friction angles.
class MapCommand : public testing::Test {
 protected:
  MapCommand() {
    db::Connection connection(folder / "a.sqlite", db::Access::write);
    std::vector<std::pair<json, double>> impacts;
    for (const double phi_d : {40, 50})
      for (const int v : {15, 20})
        for (const int seed : {1, 2})
          impacts.emplace_back(survey_scene(1, phi_d, v, 15, seed), 0.2 + 0.01 * v * seed);
    test::add_impacts(connection, impacts);
  }
  Ended map(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"map", "--db", "a.sqlite"});
    return test::eerie(folder.path(), arguments);
  }
  test::TemporaryFolder folder;
};

TEST_F(MapCommand, DrawsAllFrictionAnglesAsPanelsAndWritesTheNumbersBeside) {
  const Ended ended = map({"-o", "all.svg", "-o", "all.png", "-o", "all.pdf"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "all.svg\nall.png\nall.pdf\nall.csv\n");
  EXPECT_THAT(read_file(folder / "all.svg"), HasSubstr("= 50°,  v sin θ = 7.4 cm/s"));
  EXPECT_THAT(read_file(folder / "all.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(read_file(folder / "all.pdf"), StartsWith("%PDF"));
  EXPECT_THAT(read_file(folder / "all.csv"), HasSubstr("\n1,50,20,15,"));
}

TEST_F(MapCommand, DrawsEveryQuantity) {
  Ended ended = map({"--phi-d", "40", "--quantity", "b/a,c/a,m-lr,period", "--quantity",
                     "class,n-eer,p-eer", "-o", "seven.svg"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string seven = read_file(folder / "seven.svg");
  for (const char* words : {"b/a of the", "c/a of the", "spin period", "most frequent", "EERs per",
                            "P(largest remnant is an EER)"})
    EXPECT_THAT(seven, HasSubstr(words));
  ended = map({"--quantity", "class", "-o", "class.svg"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(read_file(folder / "class.svg"), Not(HasSubstr("b/a of the")));
}

TEST_F(MapCommand, WritesTheNumbersAlone) {
  const Ended ended = map({"--phi-d", "40", "-o", "numbers.csv", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(json::parse(ended.out), json::parse(R"({"pictures": [], "tables": ["numbers.csv"]})"));
  const std::string text = read_file(folder / "numbers.csv");
  EXPECT_EQ(std::ranges::count(text, '\n'), 3);
}

TEST_F(MapCommand, RefusesWhatItCannotDrawAndSaysWhatWouldDo) {
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"--quantity", "mass", "-o", "a.png"}, "must be one of b/a, c/a"},
      {{"--quantity", "b/a,class", "-o", "a.png"}, "choose one quantity, or one mass ratio"},
      {{"-o", "a.gif"}, "must end in .png, .svg or .pdf, or in .csv"},
      {{"--settings", "7", "-o", "a.png"},
       "--q 1 --phi-d 50 --settings 1   1000 particles, survey"},
      {{"--fidelity", "best", "-o", "a.png"},
       "--fidelity = best: must be one of sketch, survey, standard, fine, paper"},
  };
  for (const auto& [arguments, expected] : cases) {
    const Ended ended = map(arguments);
    EXPECT_EQ(ended.code, 2) << expected;
    EXPECT_THAT(ended.err, HasSubstr(expected));
    EXPECT_EQ(ended.out, "") << expected;
  }
  EXPECT_FALSE(fs::exists(folder / "a.png"));
  EXPECT_FALSE(fs::exists(folder / "a.csv"));
}

}  // namespace
}  // namespace eerie
