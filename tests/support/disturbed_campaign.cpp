#include "tests/support/disturbed_campaign.hpp"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "solver/base/file.hpp"

namespace eerie::test {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// What the impacts left behind, by job, without what the machine's mood decides.
std::map<std::string, json> outcomes(const fs::path& database) {
  std::map<std::string, json> all;
  for (const fs::path& job : job_directories(database))
    all[job.filename()] = {{"analysis", json::parse(read_file(job / "result.json")).at("analysis")},
                           {"history", read_file(job / "history.csv")},
                           {"looks", read_file(job / "remnants.csv")}};
  return all;
}

/// The undisturbed campaign; made once for each kind.
const std::map<std::string, json>& calm_outcomes(int jobs, double end_time_s) {
  static std::map<std::pair<int, double>, std::map<std::string, json>> known;
  auto& calm = known[{jobs, end_time_s}];
  if (calm.empty()) {
    const TemporaryFolder folder;
    const DisturbedCampaign campaign(folder.path(), jobs, end_time_s);
    campaign.finish_in_peace();
    calm = outcomes(campaign.database());
  }
  return calm;
}

int times(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

}  // namespace

DisturbedCampaign::DisturbedCampaign(const fs::path& folder, int jobs, double end_time_s)
    : DisturbedCampaign(folder, jobs, end_time_s, AsItIs{}) {
  submit();
}

DisturbedCampaign::DisturbedCampaign(const fs::path& folder, int jobs, double end_time_s, AsItIs)
    : folder_(folder), jobs_(jobs), end_time_s_(end_time_s) {
  json speeds = json::array();
  for (int i = 0; i < jobs; ++i) speeds.push_back(15 + i);
  write_sweep(folder, end_time_s, json{{"v_imp_cm_per_s", speeds}}.dump());
}

void DisturbedCampaign::submit() const {
  const Ended submitted = eerie(folder_, {"submit", "sweep.json"});
  EXPECT_EQ(submitted.code, 0) << submitted.err;
}

std::vector<std::string> DisturbedCampaign::daemon_words() const {
  return {"daemon", "--until-idle", "--workers", "2", "--min-free-mb", "0"};
}

void DisturbedCampaign::finish_in_peace() const {
  for (int again = 0; again < 5 && !everything_is_done(); ++again) {
    eerie(folder_, {"retry", "--all"});
    const Ended ended = eerie(folder_, daemon_words());
    EXPECT_EQ(ended.code, 0) << ended.err;
  }
}

void DisturbedCampaign::expect_whole() const {
  EXPECT_EQ(number("SELECT count(*) FROM results"), jobs_);
  EXPECT_EQ(number("SELECT count(*) FROM jobs WHERE state = 'done'"), jobs_);
  EXPECT_EQ(number("SELECT count(*) FROM attempts WHERE ended IS NULL"), 0);
  EXPECT_EQ(number("SELECT count(DISTINCT job_id) FROM attempts WHERE exit_reason = 'finished'"),
            jobs_);
  EXPECT_EQ(SQLite::Database(database()).execAndGet("PRAGMA integrity_check").getString(), "ok");
  for (const fs::path& job : job_directories(database()))
    EXPECT_LE(times(read_file(job / "log.txt"), " info done: "), 1)
        << job << " ran twice to its end";
  EXPECT_EQ(outcomes(database()), calm_outcomes(jobs_, end_time_s_));
  const Ended doctor = eerie(folder_, {"doctor"});
  EXPECT_EQ(doctor.code, 0) << doctor.out;
}

int DisturbedCampaign::number(const std::string& sql) const {
  SQLite::Database reader(database(), SQLite::OPEN_READONLY, 10'000);
  return reader.execAndGet(sql).getInt();
}

bool DisturbedCampaign::everything_is_done() const {
  return number("SELECT count(*) FROM jobs WHERE state <> 'done'") == 0;
}

std::vector<pid_t> DisturbedCampaign::workers() const {
  std::vector<pid_t> found;
  for (const fs::path& job : job_directories(database())) {
    const auto beat = job_folder::read_json(job / "heartbeat.json");
    if (beat && beat->is_object() && job_folder::WorkerLock::held({job}))
      found.push_back(static_cast<pid_t>(beat->value("pid", 0)));
  }
  return found;
}

Environment::Environment(const char* name, const std::string& value) : name_(name) {
  ::setenv(name, value.c_str(), 1);
}
Environment::~Environment() { ::unsetenv(name_); }

int from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::stoi(text);
}

}  // namespace eerie::test
