#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/disturbed_campaign.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
using nlohmann::json;
using test::Ended;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// One impact of small bodies under these settings, ended early and extended, beside the one that
/// had the later end from its start.
class Extended : public testing::Test {
 protected:
  Ended eerie(const std::vector<std::string>& words) { return test::eerie(folder.path(), words); }

  void run(const json& changes, const char* database) {
    json scene = {{"numerics", {{"particles_per_target", 100}}},
                  {"output",
                   {{"history_interval_s", 500},
                    {"snapshot_interval_s", 1000},
                    {"checkpoint_interval_s", 0.1}}}};
    scene.merge_patch(changes);
    const json sweep = {
        {"name", "one"}, {"scene", scene}, {"grid", {{"numerics.seed", json::array({1})}}}};
    install_text(folder / "one.json", sweep.dump());
    const Ended ended = eerie({"run", "one.json", "--db", database});
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
  json extend(const char* until_s) {
    const Ended ended =
        eerie({"extend", "--all", "--until", until_s, "--db", "early.sqlite", "--json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.code == 0 ? json::parse(ended.out) : json();
  }
  Ended work() { return eerie({"daemon", "--db", "early.sqlite", "--until-idle"}); }

  /// The directory of the later job in either database.
  std::pair<fs::path, fs::path> directories(const std::string& hash) {
    return {folder / "early.sqlite.jobs" / hash.substr(0, 16),
            folder / "late.sqlite.jobs" / hash.substr(0, 16)};
  }
  static void expect_same_bytes(const fs::path& extended, const fs::path& whole) {
    for (const auto& entry : fs::directory_iterator(whole)) {
      const fs::path name = entry.path().filename();
      if (name.extension() != ".hdf5" && name.extension() != ".csv") continue;
      ASSERT_TRUE(fs::exists(extended / name)) << name;
      EXPECT_TRUE(read_file(extended / name) == read_file(whole / name)) << name << " differs";
    }
    const auto lasting = [](const fs::path& folder_of) {
      json result = json::parse(read_file(folder_of / "result.json"));
      for (const char* member :
           {"wall_s", "stages_s", "threads", "steps_last_attempt", "list_builds_last_attempt"})
        result["run"].erase(member);
      return json{result["analysis"], result["run"], result["scene_hash"]};
    };
    EXPECT_EQ(lasting(extended), lasting(whole));
  }
  /// Extends what ends at `early`, and expects the bits of `late`. Returns how it went.
  json expect_extended(const json& early, const json& late, const char* until_s) {
    run(early, "early.sqlite");
    run(late, "late.sqlite");
    const json told = extend(until_s);
    if (HasFailure()) return told;
    EXPECT_EQ(told.at("jobs"), 1);
    EXPECT_EQ(work().code, 0);
    const auto [extended, whole] = directories(told.at("extended").at(0).at("as"));
    EXPECT_TRUE(fs::exists(whole)) << "another hash than that of the scene with the later end";
    if (!HasFailure()) expect_same_bytes(extended, whole);
    EXPECT_THAT(read_file(extended / "log.txt"), HasSubstr("going on from t = "));
    SQLite::Database sql(folder / "early.sqlite");
    EXPECT_EQ(sql.execAndGet("SELECT count(*) FROM results").getInt(), 2);
    EXPECT_EQ(sql.execAndGet("SELECT count(*) FROM sweep_jobs").getInt(), 2);
    const Ended doctor = eerie({"doctor", "--db", "early.sqlite"});
    EXPECT_EQ(doctor.code, 0) << doctor.out;
    return told;
  }

  /// The lines of a log with these words, without their time stamps.
  static std::vector<std::string> lines_with(const std::string& log, const std::string& words) {
    std::vector<std::string> found;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);)
      if (line.find(words) != std::string::npos) found.push_back(line.substr(line.find(" info ")));
    return found;
  }

  test::TemporaryFolder folder;
};

json ending(double time_s, const json& more = json::object()) {
  json scene = more;
  scene["end"]["time_s"] = time_s;
  return scene;
}

TEST_F(Extended, AnImpactThatEndsByTheClockHasTheBitsOfTheLongerOne) {
  const json none = {
      {"end", {{"settled", {{"window_s", 0}}}}},
      {"numerics", {{"late_sound_speed", 1}, {"flow_mach", 0}, {"rigid_flight", false}}}};
  const json told = expect_extended(ending(3000, none), ending(5000, none), "5000");
  EXPECT_GT(told.at("extended").at(0).at("from_s"), 2900);
}

TEST_F(Extended, AnImpactOfTheDefaultsThatHasNotSettledHasTheBitsOfTheLongerOne) {
  const json told = expect_extended(ending(6000), ending(9000), "9000");
  EXPECT_GT(told.at("extended").at(0).at("from_s"), 0);
}

TEST_F(Extended, AnImpactThatMayWaitForItsRemnantsHasTheBitsOfTheLongerOne) {
  const json grazing = {{"impact", {{"v_imp_cm_per_s", 6.0}, {"theta_imp_deg", 70}}},
                        {"end", {{"latest_s", 3500}}}};
  expect_extended(ending(3000, grazing), ending(4500, grazing), "4500");
}

/// Bound bodies that have grazed: they fly from each meeting to the next, about 23,000 s apart.
const json flying = {{"impact", {{"v_imp_cm_per_s", 6.5}, {"theta_imp_deg", 70}}},
                     {"output", {{"snapshot_interval_s", 30'000}}}};

TEST_F(Extended, AnImpactThatFliesToItsNextMeetingsHasTheBitsOfTheLongerOne) {
  // Before the next meeting, which would come after the end: it does not set out.
  const json told = expect_extended(ending(40'000, flying), ending(200'000, flying), "200000");
  const auto [extended, whole] = directories(told.at("extended").at(0).at("as"));
  const std::string log = read_file(extended / "log.txt");
  for (const std::string& line : lines_with(read_file(whole / "log.txt"), "are about to meet"))
    EXPECT_TRUE(line.find("t = 1002 s") != std::string::npos || log.find(line) != std::string::npos)
        << line;
  EXPECT_THAT(log, HasSubstr("are about to meet"));
}

TEST_F(Extended, AnImpactWhoseEndCameBetweenTwoFlightsHasTheBitsOfTheLongerOne) {
  const json told = expect_extended(ending(70'000, flying), ending(200'000, flying), "200000");
  EXPECT_LT(told.at("extended").at(0).at("from_s"), 70'000);
}

TEST_F(Extended, TwiceIsTheSameAsOnceToTheLastEnd) {
  run(ending(3000), "early.sqlite");
  run(ending(6000), "late.sqlite");
  extend("4500");
  ASSERT_EQ(work().code, 0);
  const json told = extend("6000");  // of both jobs, to one
  ASSERT_EQ(work().code, 0);
  EXPECT_EQ(told.at("extended").size(), 2u);
  const auto [extended, whole] = directories(told.at("extended").at(0).at("as"));
  EXPECT_EQ(told.at("extended").at(0).at("as"), told.at("extended").at(1).at("as"));
  expect_same_bytes(extended, whole);
}

TEST_F(Extended, ByACommandThatIsKilledIsExtendedByTheNextOne) {
  run(ending(3000), "early.sqlite");
  run(ending(4000), "late.sqlite");
  for (const char* point :
       {"install.before-rename@snapshot_0000.hdf5", "install.before-rename@checkpoint.hdf5",
        "install.before-folder-sync@checkpoint.hdf5"}) {
    const test::Environment armed("EERIE_KILL_AT", point);
    EXPECT_EQ(eerie({"extend", "--all", "--until", "4000", "--db", "early.sqlite"}).code,
              128 + SIGKILL)
        << point;
    SQLite::Database sql(folder / "early.sqlite");
    EXPECT_EQ(sql.execAndGet("SELECT count(*) FROM jobs").getInt(), 1);
    if (std::string(point).starts_with("install.before-folder")) break;
  }
  const json told = extend("4000");
  {
    const test::Environment armed("EERIE_KILL_AT", "install.before-rename@history.csv");
    work();
  }
  eerie({"retry", "--all", "--db", "early.sqlite"});
  ASSERT_EQ(work().code, 0);
  const auto [extended, whole] = directories(told.at("extended").at(0).at("as"));
  expect_same_bytes(extended, whole);
}

TEST_F(Extended, ByADaemonAtWorkRunsAtOnce) {
  run(ending(3000), "early.sqlite");
  test::Program daemon(folder.path(), {"daemon", "--db", "early.sqlite"});
  ASSERT_TRUE(test::eventually([&] { return fs::exists(folder / "early.sqlite.status.json"); }));
  const json told = extend("4000");
  const auto [extended, whole] = directories(told.at("extended").at(0).at("as"));
  EXPECT_TRUE(test::eventually([&] { return fs::exists(extended / "result.json"); }));
  daemon.send(SIGTERM);
  daemon.wait();
}

TEST_F(Extended, WhereItCannotBeIsRefusedWithTheReason) {
  run(ending(3000), "early.sqlite");
  const Ended earlier = eerie({"extend", "--all", "--until", "2000", "--db", "early.sqlite"});
  EXPECT_EQ(earlier.code, 2);
  EXPECT_THAT(earlier.err, HasSubstr("its end is at 3000 s; give a later time"));
  fs::remove(test::job_directories(folder / "early.sqlite").at(0) / "before_end.hdf5");
  const Ended older = eerie({"extend", "--all", "--until", "4000", "--db", "early.sqlite"});
  EXPECT_EQ(older.code, 2);
  EXPECT_THAT(older.err, HasSubstr("before_end.hdf5 is not there"));
}

TEST_F(Extended, WithoutAResultIsRefusedWithItsStateAndWhatToType) {
  run(ending(300), "early.sqlite");
  const std::string hash = test::job_directories(folder / "early.sqlite").at(0).filename();
  const auto refused = [&](const char* state, const std::string& reason) {
    {
      SQLite::Database sql(folder / "early.sqlite", SQLite::OPEN_READWRITE);
      sql.exec(std::string("UPDATE jobs SET state = '") + state + "'");
    }
    const Ended ended =
        eerie({"extend", hash.substr(0, 8), "--until", "900", "--db", "early.sqlite"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, HasSubstr("job " + hash + reason));
  };
  refused("pending", ": it is pending and has no end yet to go on from; `eerie daemon --db ");
  refused("running", ": it is running and has no end yet to go on from; extend it once it is done");
  refused("failed", ": it has failed; `eerie show " + hash.substr(0, 8) + " --db ");
  refused("cancelled", ": it was cancelled; `eerie retry " + hash.substr(0, 8) + " --db ");
  const Ended none = eerie({"extend", "0123abcd", "--until", "900", "--db", "early.sqlite"});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("no job of"));
}

}  // namespace
}  // namespace eerie
