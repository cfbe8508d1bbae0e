#include <gmock/gmock.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using test::Program;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// Debian's Python: selenium is its package, and another python3 on the PATH lacks it.
constexpr const char* python = "/usr/bin/python3";

/// A dashboard of the real program, and a real browser.
class Serve : public testing::Test {
 protected:
  Ended eerie(const std::vector<std::string>& arguments) {
    return test::eerie(folder.path(), arguments);
  }
  void submit(const std::string& name, int end_time_s, const json& grid, double cfl = 1.1) {
    install_text(folder / "sweep.json",
                 json{{"name", name},
                      {"scene",
                       {{"numerics", {{"particles_per_target", 200}, {"cfl", cfl}}},
                        {"output", {{"snapshot_interval_s", end_time_s / 4}}},
                        {"end", {{"time_s", end_time_s}}}}},
                      {"grid", grid}}
                     .dump());
    ASSERT_EQ(eerie({"submit", "sweep.json"}).code, 0);
  }
  /// Where the program says that its dashboard is: address and token.
  std::pair<std::string, std::string> address(const Program& program) {
    std::smatch match;
    std::string said;
    const std::regex line(
        "dashboard: (http://127\\.0\\.0\\.1:[0-9]+)/(?:#token=([0-9a-f]{32}))?\n");
    EXPECT_TRUE(test::eventually([&] {
      said = program.printed();
      return std::regex_search(said, match, line);
    })) << said;
    return {match[1], match[2]};
  }
  /// A script of tests/e2e/browser; what it says where it fails.
  std::string browse(const std::string& script, const std::string& arguments) {
    const fs::path out = folder / "browser.out";
    const std::string command = std::string(python) + " " +
                                (test::source_folder() / "tests/e2e/browser" / script).string() +
                                " " + arguments + " > " + out.string() + " 2>&1";
    return std::system(command.c_str()) == 0 ? "" : read_file(out);
  }
  test::TemporaryFolder folder;
};

TEST_F(Serve, ShowsEveryViewOfAFinishedCampaignInABrowser) {
  submit("shapes", 4000, {{"v_imp_cm_per_s", {15, 20}}, {"theta_imp_deg", {10, 15}}});
  ASSERT_EQ(eerie({"daemon", "--until-idle", "--workers", "2", "--min-free-mb", "1"}).code, 0);
  Program serve(folder.path(), {"serve", "--port", "0"});
  EXPECT_EQ(browse("views.py", address(serve).first), "");
  serve.send(SIGTERM);
  EXPECT_EQ(serve.wait().code, 0);
}

TEST_F(Serve, ACampaignAtWorkFillsItsCellsAndIsSteeredWithTheToken) {
  json speeds = json::array();
  for (int v = 10; v < 34; ++v) speeds.push_back(v);
  submit("long", 60000, {{"v_imp_cm_per_s", speeds}}, 0.05);
  Program daemon(folder.path(),
                 {"daemon", "--serve", "--port", "0", "--workers", "1", "--min-free-mb", "1"});
  const auto [base, token] = address(daemon);
  EXPECT_EQ(browse("alive.py", base + " " + token), "");
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait().code, 0);
}

TEST_F(Serve, APageShowsWhatItCanWithoutPicturesWithoutRoomToListenAndWithoutTheDatabase) {
  submit("shapes", 4000, {{"v_imp_cm_per_s", {15, 20}}});
  Program serve(folder.path(), {"serve", "--port", "0", "--read-only"});
  EXPECT_EQ(browse("without.py", address(serve).first + " " + (folder / "eerie.sqlite").string()),
            "");
}

TEST_F(Serve, SaysWhatIsWrongAtTheStart) {
  EXPECT_EQ(eerie({"serve", "--db", "none.sqlite"}).code, 3);
  EXPECT_FALSE(fs::exists(folder / "none.sqlite"));
  submit("shapes", 4000, {{"v_imp_cm_per_s", {15}}});
  EXPECT_EQ(eerie({"serve", "--port", "70000"}).code, 2);
  const Ended elsewhere = eerie({"serve", "--listen", "203.0.113.7"});
  EXPECT_EQ(elsewhere.code, 3);
  EXPECT_THAT(elsewhere.err, HasSubstr("cannot listen on 203.0.113.7 port"));
  Program first(folder.path(), {"serve", "--port", "0"});
  const std::string base = address(first).first;
  const Ended second = eerie({"serve", "--port", base.substr(base.rfind(':') + 1)});
  EXPECT_EQ(second.code, 3);
  EXPECT_THAT(second.err, HasSubstr("give another --port"));
}

TEST_F(Serve, ListensElsewhereOnlyWhenToldAndSaysWhatThatMeans) {
  submit("shapes", 4000, {{"v_imp_cm_per_s", {15}}});
  Program open(folder.path(), {"serve", "--port", "0", "--listen", "0.0.0.0", "--read-only"});
  EXPECT_TRUE(test::eventually([&] {
    return open.said().find("reads this database; nothing is encrypted") != std::string::npos;
  })) << open.said();
}

}  // namespace
}  // namespace eerie
