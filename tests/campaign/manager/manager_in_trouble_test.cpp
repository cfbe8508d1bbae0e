// A manager must always be able to end, and to go on.

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <future>
#include <thread>

#include "db/store/error.hpp"
#include "tests/campaign/manager/scripted_workers.hpp"

namespace eerie::manager {
namespace {
using test::Act;
using test::ManagerOn;
using test::request;
using test::ScriptedWorkers;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// Another program that writes the database for as long as it lives.
class OtherWriter {
 public:
  explicit OtherWriter(const fs::path& path) {
    thread_ = std::jthread([this, path] {
      db::Connection connection(path, db::Access::write);
      connection.write([&](auto&) {
        begun_.set_value();
        over_.get_future().wait();
      });
    });
    begun_.get_future().wait();
  }
  ~OtherWriter() { over_.set_value(); }
  OtherWriter(const OtherWriter&) = delete;
  OtherWriter& operator=(const OtherWriter&) = delete;

 private:
  std::promise<void> begun_, over_;
  std::jthread thread_;
};

class ManagerInTrouble : public ManagerOn {
 protected:
  job_folder::JobDirectory directory_of(std::size_t scene) { return directory(scenes.at(scene)); }
};

TEST_F(ManagerInTrouble, WaitsForADatabaseThatAnotherProgramWritesAndGoesOn) {
  ScriptedWorkers workers({});
  Manager manager(connection, workers, {.sweep = sweep});
  auto other = std::make_unique<OtherWriter>(connection.path());
  bool waited = false;
  manager.run([] { return 0; },
              [&](const CampaignView& view) {
                if (view.waiting_for.find("another program") == std::string::npos) return;
                waited = true;
                other.reset();
              });
  EXPECT_TRUE(waited);
  EXPECT_EQ(manager.view().done, 3u);
  EXPECT_EQ(manager.view().waiting_for, "");
}

TEST_F(ManagerInTrouble, EndsWhenToldToWhoeverHoldsTheDatabaseAndTheNextTakesTheResults) {
  ScriptedWorkers workers({});
  std::unique_ptr<OtherWriter> other;
  Manager manager(connection, workers, {.sweep = sweep});
  // Workers have begun and the database is taken before their ends can be noted.
  manager.run([&] { return other ? 1 : 0; },
              [&](const CampaignView& view) {
                if (view.running > 0 || workers.starts > 0)
                  if (!other) other = std::make_unique<OtherWriter>(connection.path());
              });
  other.reset();
  ScriptedWorkers again({});
  EXPECT_EQ(work(again).done, 3u);
  EXPECT_EQ(workers.starts + again.starts, 3) << "nothing was computed twice";
}

TEST_F(ManagerInTrouble, EndsWhenToldToThoughTheEndOfAWorkerCannotBeNoted) {
  ScriptedWorkers workers({Act::wait, Act::wait});
  std::unique_ptr<OtherWriter> other;
  Manager manager(connection, workers, {.sweep = sweep});
  manager.run([&] { return other ? 1 : 0; },
              [&](const CampaignView& view) {
                if (view.running == 2 && !other)
                  other = std::make_unique<OtherWriter>(connection.path());
              });
  EXPECT_EQ(workers.stops, 1);
  EXPECT_EQ(in_state(db::JobState::running), 2u) << "as the database knows it";
  other.reset();
  ScriptedWorkers again({});
  EXPECT_EQ(work(again).done, 3u);
}

/// A regular file that opens and cannot be read, for root neither: /proc/self/mem at 0.
void make_unreadable(const fs::path& file) {
  fs::create_directories(file.parent_path());
  fs::remove(file);
  fs::create_symlink("/proc/self/mem", file);
}

TEST_F(ManagerInTrouble, WaitsForAResultThatCannotBeReadAndDoesTheOthersMeanwhile) {
  ScriptedWorkers workers({Act::unreadable});
  Manager manager(connection, workers, {.sweep = sweep});
  bool waited = false;
  manager.run([] { return 0; },
              [&](const CampaignView& view) {
                if (view.done < 2 || view.waiting_for.find("result.json") == std::string::npos)
                  return;
                waited = true;
                for (const Scene& scene : scenes)
                  if (fs::is_symlink(directory(scene).result())) {
                    fs::remove(directory(scene).result());
                    test::install_result(directory(scene), scene);
                  }
              });
  EXPECT_TRUE(waited);
  EXPECT_EQ(manager.view().done, 3u);
  EXPECT_EQ(workers.starts, 3);
}

TEST_F(ManagerInTrouble, EndsWhenToldToThoughAResultCannotBeRead) {
  ScriptedWorkers workers({Act::unreadable});
  Manager manager(connection, workers, {.sweep = sweep});
  manager.run([&] { return manager.view().waiting_for.empty() ? 0 : 1; },
              [](const CampaignView&) {});
  EXPECT_EQ(in_state(db::JobState::running), 1u);
  ScriptedWorkers again({});
  Manager next(connection, again, {.sweep = sweep});  // it starts, and ends, as well
  next.run([&] { return next.view().done < 2 ? 0 : 1; }, [](const CampaignView&) {});
  EXPECT_EQ(workers.starts + again.starts, 3);
}

using Damage = std::function<void(const job_folder::JobDirectory&)>;
struct BadDirectory {
  const char* name;
  Damage damage;
};
class ManagerOnABadDirectory : public ManagerOn,
                               public testing::WithParamInterface<BadDirectory> {};

TEST_P(ManagerOnABadDirectory, FailsThatJobWithTheReasonAndDoesTheOthers) {
  const job_folder::JobDirectory bad = directory(scenes[1]);
  fs::create_directories(bad.path.parent_path());
  GetParam().damage(bad);
  ScriptedWorkers workers({});
  const CampaignView view = work(workers);
  EXPECT_EQ(view.done, 2u);
  EXPECT_EQ(view.failed, 1u);
  const auto causes = db::failures(connection, sweep);
  ASSERT_EQ(causes.size(), 1u);
  EXPECT_EQ(causes[0].kind, "job-directory");
  EXPECT_THAT(causes[0].example_message, HasSubstr(bad.path.filename()));
  fs::remove_all(bad.path);
  apply(connection, request("retry"));
  ScriptedWorkers again({});
  EXPECT_EQ(work(again).done, 3u);
}

void put_folder(const fs::path& path) { fs::create_directories(path / "inside"); }
void put_pipe(const fs::path& path) {
  fs::create_directories(path.parent_path());
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
}

INSTANTIATE_TEST_SUITE_P(
    WhereThereIs, ManagerOnABadDirectory,
    testing::Values(
        BadDirectory{"AFileInItsPlace", [](const auto& d) { std::ofstream(d.path) << "x"; }},
        BadDirectory{"AFolderForItsLastWord", [](const auto& d) { put_folder(d.ended()); }},
        BadDirectory{"AFolderForItsScene", [](const auto& d) { put_folder(d.scene()); }},
        BadDirectory{"AFolderForItsResult", [](const auto& d) { put_folder(d.result()); }},
        BadDirectory{"AFolderForItsHeartbeat", [](const auto& d) { put_folder(d.heartbeat()); }},
        BadDirectory{"APipeForItsLog", [](const auto& d) { put_pipe(d.log()); }},
        BadDirectory{"APipeForItsLock", [](const auto& d) { put_pipe(d.worker_lock()); }},
        BadDirectory{"AnUnreadableResult", [](const auto& d) { make_unreadable(d.result()); }}),
    [](const auto& one) { return std::string(one.param.name); });

TEST_F(ManagerInTrouble, RunsAJobAgainWhoseResultClaimsAVersionThatIsNone) {
  for (const char* version : {"9/9", "../../9", ""}) {
    const Scene& scene = scenes[0];
    test::install_result(directory(scene), scene);
    test::forge_version(directory(scene), version);
    EXPECT_FALSE(job_folder::read_result(directory(scene), scene_hash(scene))) << version;
  }
  ScriptedWorkers workers({});
  EXPECT_EQ(work(workers).done, 3u);
  EXPECT_EQ(workers.starts, 3);
}

TEST_F(ManagerInTrouble, GoesOnThoughNobodyCanReadItsProgress) {
  ScriptedWorkers workers({});
  Manager manager(connection, workers, {.sweep = sweep});
  manager.run([] { return 0; },
              [](const CampaignView&) { throw std::system_error(EPIPE, std::generic_category()); });
  EXPECT_EQ(manager.view().done, 3u);
}

TEST_F(ManagerInTrouble, EndsWithTheReasonWhereItsDatabaseIsRemoved) {
  ScriptedWorkers workers({Act::wait, Act::wait});
  Manager manager(connection, workers, {.sweep = sweep});
  try {
    manager.run([] { return 0; },
                [&](const CampaignView& view) {
                  if (view.running == 2) fs::remove(connection.path());
                });
    FAIL() << "it worked on a database that is not there";
  } catch (const db::GoneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("removed"));
  }
  EXPECT_EQ(workers.stops, 1) << "workers are told to leave checkpoints";
}

TEST_F(ManagerInTrouble, EndsWithTheReasonWhereItsDatabaseIsRemovedAtTheVeryEnd) {
  ScriptedWorkers workers({});
  Manager manager(connection, workers, {.sweep = sweep});
  EXPECT_THROW(manager.run([] { return 0; },
                           [&](const CampaignView& view) {
                             if (view.done == 3) fs::remove(connection.path());
                           }),
               db::GoneError);
}

TEST_F(ManagerInTrouble, KillsNoJobWhereTheWholeFolderOfJobsIsTheTrouble) {
  ScriptedWorkers workers({});
  Manager manager(connection, workers, {.sweep = sweep});
  const fs::path root = job_folder::job_folder(connection).root;
  fs::remove_all(root);
  std::ofstream(root) << "a file";
  bool waited = false;
  manager.run([] { return 0; },
              [&](const CampaignView& view) {
                if (view.waiting_for.empty()) return;
                waited = true;
                fs::remove(root);
              });
  EXPECT_TRUE(waited);
  EXPECT_EQ(manager.view().done, 3u);
}

}  // namespace
}  // namespace eerie::manager
