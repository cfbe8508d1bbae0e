#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class Disk : public testing::Test {
 protected:
  Ended disk(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "disk");
    return test::eerie(folder.path(), arguments);
  }
  std::set<std::string> files(const char* in = ".") {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder / in))
      names.insert(entry.path().filename());
    return names;
  }
  test::TemporaryFolder folder;
};

TEST_F(Disk, PrintsThePapersNumbersBesideItsOwnAndWritesNothing) {
  const Ended ended = disk({});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("Hayashi's nebula at 5 AU"));
  EXPECT_THAT(ended.out, HasSubstr("published drag"));
  EXPECT_THAT(ended.out, HasSubstr("d_R/R_c, b/a = 0.1"));
  EXPECT_THAT(ended.out, HasSubstr("agrees"));
  EXPECT_EQ(ended.err, "");
  EXPECT_TRUE(files().empty());
}

TEST_F(Disk, AnswersInJsonWhatItWasAsked) {
  const Ended ended = disk({"--r", "30", "--alpha", "4e-4", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json report = json::parse(ended.out);
  EXPECT_EQ(report["nebula"]["r_au"], 30);
  ASSERT_EQ(report["places"].size(), 2u);
  const json& published = report["places"][0];
  EXPECT_EQ(published["drag"], "published");
  EXPECT_EQ(published["regime"], "Epstein");
  // Eqs. (6) and (7) again, from what the answer itself says of the gas.
  const double t_s = 22 * std::pow(30, 1.5);
  EXPECT_NEAR(published["t_s_omega_k"], t_s, 1e-6 * t_s);
  const double c = report["nebula"]["sound_speed_m_per_s"];
  EXPECT_NEAR(published["turbulent_speed_cm_per_s"], 100 * c * std::sqrt(3 * 4e-4 / t_s), 1e-6);
  EXPECT_GT(report["paper"].size(), 20u);
  EXPECT_TRUE(report["files"].empty());
}

TEST_F(Disk, DrawsBothFiguresAndWritesTheirNumbers) {
  const Ended ended = disk(
      {"-o", "disk", "--format", "svg", "--format", "png", "--r-range", "0.5:50", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(
      files("disk"),
      (std::set<std::string>{"numbers.csv", "turbulence.csv", "stirring.csv", "turbulence.svg",
                             "stirring.svg", "turbulence.png", "stirring.png"}));
  EXPECT_EQ(json::parse(ended.out)["files"].size(), 7u);
  EXPECT_THAT(read_file(folder / "disk/turbulence.svg"), HasSubstr("<svg"));
  EXPECT_THAT(read_file(folder / "disk/stirring.png"), testing::StartsWith("\x89PNG"));
  const std::string csv = read_file(folder / "disk/stirring.csv");
  EXPECT_THAT(csv, HasSubstr("stirrer_radius_km_at_40_cm_per_s"));
  EXPECT_THAT(csv, HasSubstr("\npublished,0.5,Newton,"));
  EXPECT_THAT(csv, HasSubstr("\nweidenschilling,50,Epstein,"));
}

TEST_F(Disk, TakesOtherBodiesByWeidenschillingsDragAndWarnsOfSmallOnes) {
  const Ended other = disk({"--radius", "50"});
  ASSERT_EQ(other.code, 0) << other.err;
  EXPECT_THAT(other.out, HasSubstr("weidenschilling drag"));
  EXPECT_THAT(other.out, Not(HasSubstr("published drag")));
  EXPECT_EQ(other.err, "");
  const Ended pebble = disk({"--radius", "1"});
  EXPECT_EQ(pebble.code, 0);
  EXPECT_THAT(pebble.err, HasSubstr("warning: Omega t_s"));
}

TEST_F(Disk, RefusesWhatIsOutOfRangeAndSaysWhatWouldDo) {
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"--r", "0"}, "--r = 0: must be 0.05 to 1000 AU; for example --r 5"},
      {{"--alpha", "2"}, "--alpha = 2: must be 1e-10 to 1; for example --alpha 0.0001"},
      {{"--alpha", "nan"}, "--alpha = nan"},
      {{"--stirrer-radius", "-1"}, "--stirrer-radius = -1: must be 0.01 to 3000 km"},
      {{"--solid-fraction", "3"}, "--solid-fraction = 3"},
      {{"--phi-d", "90"}, "--phi-d = 90: must be 1 to 89 deg"},
      {{"--b-over-a", "1.2"}, "--b-over-a = 1.2: must be 0.01 to 1"},
      {{"--radius", "0"}, "--radius = 0: must be 0.1 to 1e+06 m"},
      {{"--density", "1"}, "--density = 1: must be 100 to 10000 kg/m^3"},
      {{"--r-range", "5:6"}, "--r-range 5:6: HI must be 10 (twice LO) to 1000 AU"},
      {{"--r-range", "0:6"}, "--r-range (LO) = 0"},
      {{"--r-range", "far"}, "--r-range far"},
      {{"--drag", "epstein"}, "--drag"},
      {{"--drag", "published", "--radius", "50"}, "give drag = weidenschilling"},
      {{"--format", "gif"}, "--format"},
  };
  for (auto [arguments, expected] : cases) {
    arguments.insert(arguments.end(), {"-o", "figures"});
    const Ended ended = disk(arguments);
    EXPECT_EQ(ended.code, 2) << expected;
    EXPECT_THAT(ended.err, HasSubstr(expected));
    EXPECT_EQ(ended.out, "") << expected;
  }
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace eerie
