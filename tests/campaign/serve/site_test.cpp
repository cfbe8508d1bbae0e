#include "campaign/serve/site.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/job_directory.hpp"
#include "db/jobs/control.hpp"
#include "db/store/error.hpp"
#include "solver/base/file.hpp"
#include "tests/support/impact_database.hpp"
#include "tests/support/program.hpp"

namespace eerie::serve {
namespace {
using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// Surveys at 40 deg: two speeds, two angles, two seeds each, b/a = 0.2 to 0.55; one failed, one
/// pending, and a cell without a job.
class SiteOfADatabase : public testing::Test {
 protected:
  SiteOfADatabase() {
    std::vector<std::pair<json, double>> impacts;
    for (const int v : {15, 20})
      for (const int theta : {10, 15})
        for (const int seed : {1, 2})
          impacts.emplace_back(test::survey_scene(1, 40, v, theta, seed),
                               0.2 + 0.02 * (v - 15) + 0.01 * (theta - 10) + 0.1 * (seed - 1));
    test::add_impacts(connection, impacts);
    const std::vector more = {sweeps::new_job(parse_scene(test::survey_scene(1, 40, 25, 10, 1))),
                              sweeps::new_job(parse_scene(test::survey_scene(1, 40, 25, 15, 1)))};
    add_sweep(connection, "more", "{}", more);
    for (const db::Job& job : db::jobs(connection, {.state = db::JobState::pending})) {
      if (job.theta_imp_deg != 10) continue;
      db::begin_attempts(connection, std::vector{db::Start{job.id, "here", "7", "0.1.0"}});
      db::AttemptEnd end = test::ended(db::ExitReason::failed);
      end.failure_kind = "not-finite";
      db::end_attempt(connection, job.id, end, db::JobState::failed);
    }
  }
  json get(const std::string& path, const Parameters& parameters = {}) {
    const Reply reply = site.answer(path, parameters);
    EXPECT_EQ(reply.status, 200) << path << ": " << reply.body;
    return json::parse(reply.body);
  }
  std::string first_hash() { return db::jobs(connection, {}).front().hash; }

  test::TemporaryFolder folder;
  db::Connection connection{folder / "a.sqlite", db::Access::write};
  Events events{folder / "a.sqlite"};
  Site site{folder / "a.sqlite", false, events};
  const Parameters map = {{"q", "1"}, {"phi_d", "40"}, {"settings", "1"}};
};

TEST_F(SiteOfADatabase, CountsEachJobOnce) {
  const json campaign = get("/api/campaign");
  EXPECT_EQ(campaign["jobs"]["done"], 8);
  EXPECT_EQ(campaign["jobs"]["failed"], 1);
  EXPECT_EQ(campaign["jobs"]["total"], 10);
  EXPECT_EQ(campaign["failures"][0]["kind"], "not-finite");
  EXPECT_EQ(get("/api/timeline")["spans"].size(), 9u);
}

TEST_F(SiteOfADatabase, GivesAMapWithTheMeansOverSeeds) {
  EXPECT_EQ(get("/api/maps")["maps"].size(), 1u);
  const json m = get("/api/map", map);
  EXPECT_EQ(m["v"]["at"], json({15.0, 20.0, 25.0}));
  EXPECT_EQ(m["paper_cm_per_s"], 5.1);
  ASSERT_EQ(m["cells"].size(), 6u);
  std::map<std::string, int> states;
  for (const json& cell : m["cells"]) {
    ++states[cell["state"].get<std::string>()];
    if (cell["results"] == 0) continue;
    const double v = cell["v"], theta = cell["theta"];
    EXPECT_NEAR(cell["b_over_a"][0].get<double>(), 0.25 + 0.02 * (v - 15) + 0.01 * (theta - 10),
                1e-12);
    EXPECT_NEAR(cell["b_over_a"][1].get<double>(), 0.1 / std::sqrt(2.0), 1e-12);
    EXPECT_EQ(cell["colours"].size(), 7u) << "all quantities of `eerie map`";
  }
  EXPECT_EQ(states, (std::map<std::string, int>{{"done", 4}, {"failed", 1}, {"pending", 1}}));
}

TEST_F(SiteOfADatabase, PagesFiltersAndSortsAllJobs) {
  json page = get("/api/jobs", {{"limit", "3"}, {"offset", "9"}});
  EXPECT_EQ(page["total"], 10);
  EXPECT_EQ(page["rows"].size(), 1u);
  page = get("/api/jobs", {{"state", "failed"}});
  EXPECT_EQ(page["total"], 1);
  page = get("/api/jobs", {{"v", "15:20"}, {"where", "b_over_a=0:0.305"}, {"sort", "-b_over_a"}});
  EXPECT_EQ(page["total"], 4);
  std::vector<std::string> columns;
  for (const json& column : page["columns"]) columns.push_back(column["name"]);
  EXPECT_THAT(columns, testing::Contains("v_imp_cm_per_s"));
  EXPECT_THAT(columns, testing::Not(testing::Contains("phi_d_deg"))) << "all have the same";
  const auto k = std::ranges::find(columns, "b_over_a") - columns.begin();
  EXPECT_DOUBLE_EQ(page["rows"][0][k].get<double>(), 0.3);
  const Reply csv = site.answer("/api/jobs.csv", {{"state", "failed"}});
  EXPECT_EQ(std::ranges::count(csv.body, '\n'), 2);
  EXPECT_THAT(csv.body, StartsWith("hash,state,"));
}

TEST_F(SiteOfADatabase, ShowsWhatOfASceneDiffersFirst) {
  const json job = get("/api/job/" + first_hash());
  EXPECT_EQ(job["hash"], first_hash());
  EXPECT_EQ(job["leaves"][0]["differs"], true);
  std::map<std::string, json> differing;
  for (const json& leaf : job["leaves"])
    if (leaf["differs"] == true) differing[leaf["path"]] = leaf["value"];
  EXPECT_TRUE(differing.contains("numerics.particles_per_target"));
  EXPECT_FALSE(differing.contains("impact.q"));
  EXPECT_EQ(get("/api/job/" + first_hash() + "/log")["text"], "");
  EXPECT_EQ(get("/api/job/" + first_hash() + "/history")["columns"], json::object());
  EXPECT_EQ(get("/api/job/" + first_hash().substr(0, 10))["hash"], first_hash());
}

TEST_F(SiteOfADatabase, FollowsALogFromWhereItWas) {
  const auto directory = job_folder::job_folder(connection).of(first_hash());
  std::filesystem::create_directories(directory.path);
  install_text(directory.log(), "first\nsecond\n");
  const std::string address = "/api/job/" + first_hash() + "/log";
  EXPECT_EQ(get(address, {{"from", "6"}})["text"], "second\n");
  EXPECT_EQ(get(address, {{"from", "13"}})["text"], "");
  EXPECT_EQ(get(address, {{"from", "999"}})["text"], "first\nsecond\n") << "it was made anew";
}

TEST_F(SiteOfADatabase, AnswersEveryAddressOfThePageWithIt) {
  for (const char* path : {"/", "/campaign", "/map", "/jobs", "/job/0123456789ab", "/compare"})
    EXPECT_THAT(site.answer(path, {}).type, HasSubstr("text/html")) << path;
  const Reply script = site.answer("/page/main.js", {});
  EXPECT_THAT(script.type, HasSubstr("text/javascript"));
  EXPECT_FALSE(script.etag.empty());
}

TEST_F(SiteOfADatabase, HoldsTheLibrariesOfThePageAndTheirNotices) {
  EXPECT_THAT(site.answer("/page/d3.min.js", {}).body, HasSubstr("d3.svg.axis"));
  EXPECT_THAT(site.answer("/page/three.module.js", {}).body, HasSubstr("WebGLRenderer"));
  EXPECT_THAT(site.answer("/page/TrackballControls.js", {}).body,
              HasSubstr("from \"./three.module.js\""));
  const Reply notices = site.answer("/page/copyright.txt", {});
  EXPECT_THAT(notices.type, HasSubstr("text/plain"));
  for (const char* holder : {"the eerie authors", "Michael Bostock", "three.js"})
    EXPECT_THAT(notices.body, HasSubstr(holder));
}

TEST_F(SiteOfADatabase, SaysWhatIsWrongWithAnAddress) {
  for (const char* path : {"/api/nothing", "/page/../campaign/main.cpp", "/page/", "/etc/passwd",
                           "/../../etc/passwd", "/api/", "/map/"})
    EXPECT_EQ(site.answer(path, {}).status, 404) << path;
  EXPECT_EQ(site.answer("/api/job/" + first_hash() + "/../..", {}).status, 404);
  EXPECT_EQ(site.answer("/api/job/../../x", {}).status, 400);
  EXPECT_EQ(site.answer("/api/job/ffffffff", {}).status, 400) << "no such job";
  EXPECT_EQ(site.answer("/api/map", {{"q", "one"}}).status, 400);
  EXPECT_EQ(site.answer("/api/map", {{"q", "7"}}).status, 400) << "no such map";
  EXPECT_EQ(site.answer("/api/jobs", {{"limit", "100000000"}}).status, 400);
  EXPECT_EQ(site.answer("/api/jobs", {{"sort", "job; DROP TABLE jobs"}}).status, 400);
  EXPECT_THAT(site.answer("/api/jobs", {{"where", "b_ovr_a=1"}}).body, HasSubstr("closest"));
  EXPECT_EQ(site.answer("/api/job/" + first_hash() + "/particles", {{"snapshot", "../../a.sqlite"}})
                .status,
            400);
}

TEST_F(SiteOfADatabase, NamesAParameterThatItDoesNotKnowOrThatIsGivenTwice) {
  const std::string job = "/api/job/" + first_hash();
  for (const auto& [path, parameters] : std::vector<std::pair<std::string, Parameters>>{
           {"/api/campaign", {{"nope", "1"}}},
           {"/api/about", {{"nope", ""}}},
           {"/api/news", {{"nope", "1"}}},
           {"/api/timeline", {{"nope", "1"}}},
           {"/api/maps", {{"nope", "1"}}},
           {"/api/map", {{"q", "1"}, {"phi_d", "40"}, {"settings", "1"}, {"nope", "x"}}},
           {"/api/jobs", {{"limit", "1"}, {"nope", "2"}}},
           {"/api/jobs.csv", {{"nope", "2"}}},
           {job, {{"nope", "1"}}},
           {job + "/history", {{"nope", "1"}}},
           {job + "/log", {{"from", "1"}, {"nope", "1"}}}}) {
    const Reply reply = site.answer(path, parameters);
    EXPECT_EQ(reply.status, 400) << path;
    EXPECT_THAT(reply.body, HasSubstr("nope")) << path;
  }
  EXPECT_THAT(site.answer("/api/jobs", {{"limit", "1"}, {"limit", "2"}}).body,
              HasSubstr("limit: is given twice"));
  EXPECT_EQ(get("/api/jobs", {{"where", "seed=1"}, {"where", "b_over_a=0:0.305"}})["total"], 3);
  EXPECT_EQ(site.answer("/map", {{"quantity", "class"}, {"q", "1"}}).status, 200)
      << "what the page itself keeps in its address";
}

TEST_F(SiteOfADatabase, ShowsAChangeOnceItIsSeen) {
  EXPECT_EQ(get("/api/campaign")["jobs"]["pending"], 1);
  connection.write([](auto& sql) { db::cancel(sql, {}); });
  EXPECT_TRUE(test::eventually([&] { return get("/api/campaign")["jobs"]["cancelled"] == 2; }));
}

/// A database that is one whole file, since nobody has it open.
void make_database(const std::filesystem::path& path, int jobs) {
  db::Connection connection(path, db::Access::write);
  add_sweep(connection, "all", "{}", test::sample_jobs(jobs));
}

/// Two jobs in a file that others move about.
class SiteOfAFileThatGoes : public testing::Test {
 protected:
  SiteOfAFileThatGoes() {
    make_database(database, 2);
    make_database(folder / "b.sqlite", 5);
  }
  Reply campaign() { return site->answer("/api/campaign", {}); }
  bool shows(int jobs) {
    return test::eventually([&] {
      const Reply reply = campaign();
      return reply.status == 200 && json::parse(reply.body)["jobs"]["total"] == jobs;
    });
  }
  void serve(const std::filesystem::path& path) {
    events = std::make_unique<Events>(path);
    site = std::make_unique<Site>(path, false, *events);
  }
  test::TemporaryFolder folder;
  std::filesystem::path database = folder / "a.sqlite";
  std::unique_ptr<Events> events;
  std::unique_ptr<Site> site;
};

TEST_F(SiteOfAFileThatGoes, ShowsTheFileThatTookItsPlace) {
  serve(database);
  EXPECT_TRUE(shows(2));
  std::filesystem::rename(folder / "b.sqlite", database);
  EXPECT_TRUE(shows(5));
}

TEST_F(SiteOfAFileThatGoes, ShowsItAtOnceHoweverMuchRepliesCost) {
  serve(database);
  EXPECT_TRUE(shows(2));
  events->note_cost(std::chrono::seconds(60));  // else the next generation comes in a minute
  std::filesystem::rename(folder / "b.sqlite", database);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(shows(5));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(45));
}

TEST_F(SiteOfAFileThatGoes, ShowsTheFileToWhichALinkNowLeads) {
  std::filesystem::create_symlink("a.sqlite", folder / "link.sqlite");
  serve(folder / "link.sqlite");
  EXPECT_TRUE(shows(2));
  std::filesystem::remove(folder / "link.sqlite");
  std::filesystem::create_symlink("b.sqlite", folder / "link.sqlite");
  EXPECT_TRUE(shows(5));
}

TEST_F(SiteOfAFileThatGoes, SaysThatItIsGoneUntilItIsBack) {
  serve(database);
  EXPECT_TRUE(shows(2));
  std::filesystem::rename(database, folder / "away.sqlite");
  EXPECT_TRUE(test::eventually([&] { return campaign().status == 503; }));
  EXPECT_THAT(campaign().body, HasSubstr("there is no such file"));
  EXPECT_TRUE(test::eventually(
      [&] { return events->latest().find("there is no such file") != std::string::npos; }));
  std::filesystem::rename(folder / "away.sqlite", database);
  EXPECT_TRUE(shows(2));
  EXPECT_TRUE(
      test::eventually([&] { return events->latest().find("problem") == std::string::npos; }));
}

TEST_F(SiteOfAFileThatGoes, SaysWhyAFileOfAnotherVersionIsNotShown) {
  serve(database);
  EXPECT_TRUE(shows(2));
  db::Connection connection(database, db::Access::write);
  for (const char* version : {"-1", "99999"}) {
    connection.write([&](auto& sql) { sql.exec(std::string("PRAGMA user_version = ") + version); });
    const std::string reason = std::string("its schema has version ") + version;
    EXPECT_TRUE(test::eventually([&] { return campaign().body.find(reason) != std::string::npos; }))
        << campaign().body;
    EXPECT_EQ(campaign().status, 503);
  }
}

TEST_F(SiteOfAFileThatGoes, TakesNoActionOnAFileThatNobodyHasSeen) {
  serve(database);
  EXPECT_TRUE(shows(2));
  EXPECT_TRUE(
      test::eventually([&] { return json::parse(events->latest())["database"].is_object(); }));
  EXPECT_NO_THROW(events->require_shown());
  events->end();  // it looks no more
  make_database(folder / "c.sqlite", 7);
  std::filesystem::rename(folder / "c.sqlite", database);
  EXPECT_THROW(events->require_shown(), db::GoneError);
}

}  // namespace
}  // namespace eerie::serve
