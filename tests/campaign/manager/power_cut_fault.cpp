// The campaign against power cuts: what a short campaign does to the disk is recorded, and at
// instants of it the disk is built anew as a power cut would leave it; eerie then goes on from
// there.

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "solver/base/file.hpp"
#include "tests/support/disk_model.hpp"
#include "tests/support/disturbed_campaign.hpp"
#include "tests/support/paths.hpp"

namespace eerie::manager {
namespace {
using test::DiskEvent;
using test::DiskModel;
using test::DisturbedCampaign;
using test::Unsynced;
namespace fs = std::filesystem;

constexpr int jobs = 3;
constexpr double end_time_s = 600;
using testing::HasSubstr;

/// Submits, works, and has a request carried out meanwhile; `said` tells what was acknowledged.
/// (In a sanitized build leaks cannot be looked for in processes that are traced.)
std::string script() {
  const std::string eerie = "'" + test::program().string() + "'";
  return "exec >> said 2>&1\nexport ASAN_OPTIONS=detect_leaks=0\n" + eerie +
         " submit sweep.json && echo acknowledged: sweep\n" + eerie +
         " daemon --until-idle --workers 2 --min-free-mb 0 &\n" +
         "until grep -q event=daemon said || ! kill -0 $!; do sleep 0.02; done\n" + eerie +
         " priority 7 --all && echo acknowledged: priority\nwait\n";
}

/// What the world was told before a power cut.
struct Acknowledged {
  bool sweep = false, priority = false;
  std::set<std::string> jobs;  ///< first digits of their hashes

  explicit Acknowledged(const std::string& said)
      : sweep(said.find("acknowledged: sweep") != std::string::npos),
        priority(said.find("acknowledged: priority") != std::string::npos) {
    const std::string mark = "event=ended job=";
    for (std::size_t at = said.find(mark); at != std::string::npos; at = said.find(mark, at + 1)) {
      const std::string line = said.substr(at, said.find('\n', at) - at);
      if (line.ends_with("state=done")) jobs.insert(line.substr(mark.size(), 16));
    }
  }
};

/// What a doctor may find after a power cut: work that was on its way, and can go on. All else
/// would be lost.
void expect_nothing_but_unfinished_work(const std::string& findings) {
  constexpr const char* unfinished[] = {
      "counts as running and has no worker", "a result that the database does not know",
      "has an attempt without an end", "was left half written", "checkpoint"};
  const std::string mark = "found: ";
  for (std::size_t at = findings.find(mark); at != std::string::npos;
       at = findings.find(mark, at + 1)) {
    const std::string line = findings.substr(at, findings.find('\n', at) - at);
    EXPECT_TRUE(std::ranges::any_of(unfinished, [&](const char* words) {
      return line.find(words) != std::string::npos;
    })) << line;
  }
}

/// Fails the test where something acknowledged is not there, or is computed again.
void expect_nothing_lost(const DiskModel::State& state, const Acknowledged& told) {
  const test::TemporaryFolder folder;
  test::install_state(state, folder.path());
  const DisturbedCampaign campaign(folder.path(), jobs, end_time_s, DisturbedCampaign::AsItIs{});
  if (told.sweep) {
    const test::Ended doctor = test::eerie(folder.path(), {"doctor"});
    EXPECT_THAT(doctor.code, testing::AnyOf(0, 3)) << doctor.out << doctor.err;
    expect_nothing_but_unfinished_work(doctor.out);
    EXPECT_EQ(campaign.number("SELECT count(*) FROM jobs"), jobs);
    for (const std::string& job : told.jobs)
      EXPECT_EQ(campaign.number("SELECT count(*) FROM job_results JOIN jobs ON jobs.id = job_id "
                                "WHERE state = 'done' AND jobs.hash LIKE '" +
                                job + "%'"),
                1)
          << job << " was done";
  }
  campaign.submit();
  campaign.finish_in_peace();
  campaign.expect_whole();
  for (const std::string& job : told.jobs)
    EXPECT_EQ(campaign.number("SELECT count(*) FROM attempts JOIN jobs ON jobs.id = job_id "
                              "WHERE exit_reason = 'finished' AND jobs.hash LIKE '" +
                              job + "%'"),
              1)
        << job << " was computed again";
  if (told.priority) {
    EXPECT_EQ(campaign.number("SELECT min(priority) FROM jobs"), 7);
  }
}

TEST(PowerCuts, LoseNothingThatWasAcknowledged) {
  const int wanted = test::from_environment("EERIE_FAULT_POWER_CUTS", 25);
  const test::TemporaryFolder folder;
  const DisturbedCampaign campaign(folder.path(), jobs, end_time_s, DisturbedCampaign::AsItIs{});
  DiskModel disk(folder.path());
  std::vector<DiskEvent> events;
  try {
    events = test::recorded(folder.path(), script());
  } catch (const test::NoTracing& error) {
    GTEST_SKIP() << error.what();
  }
  ASSERT_EQ(Acknowledged(read_file(folder / "said")).jobs.size(), static_cast<std::size_t>(jobs))
      << read_file(folder / "said");
  ASSERT_THAT(read_file(folder / "said"), HasSubstr("acknowledged: priority"));
  campaign.expect_whole();

  std::mt19937 dice(static_cast<unsigned>(test::from_environment("EERIE_FAULT_SEED", 1)));
  std::string said;
  std::set<DiskModel::State> seen;
  const std::size_t possible = std::size(test::unsynced_kinds) * events.size();
  std::size_t states = 0, at = 0;
  for (std::size_t k = 0; k < events.size() && !HasFailure(); ++k) {
    disk.apply(events[k]);
    if (events[k].kind == DiskEvent::Kind::say) said += events[k].bytes;
    for (const Unsynced unsynced : test::unsynced_kinds) {
      // Spread evenly; one that has been seen makes room for the next.
      if (++at * static_cast<std::size_t>(wanted) < states * possible) continue;
      const DiskModel::State state = disk.after_cut(unsynced, dice);
      if (!seen.insert(state).second) continue;
      ++states;
      SCOPED_TRACE("cut after event " + std::to_string(k) + " of " + std::to_string(events.size()) +
                   ", " + events[k].path.string() +
                   ", unsynced data: " + std::to_string(static_cast<int>(unsynced)));
      expect_nothing_lost(state, Acknowledged(said));
    }
  }
  if (HasFailure()) return;
  EXPECT_EQ(Acknowledged(said).jobs.size(), static_cast<std::size_t>(jobs));
  std::printf("%zu events, %zu states after a power cut: nothing lost\n", events.size(), states);
}

// A disk that forgets what was never flushed must show a program that does not flush.
TEST(PowerCuts, WouldShowAFileThatIsRenamedBeforeItIsFlushed) {
  const test::TemporaryFolder folder;
  DiskModel disk(folder.path());
  for (const DiskEvent& event : test::recorded(
           folder.path(), "echo whole > new; mv new name; mkdir below; echo x > below/y"))
    disk.apply(event);
  std::mt19937 dice;
  EXPECT_EQ(disk.after_cut(Unsynced::kept, dice),
            (DiskModel::State{{"name", "whole\n"}, {"below/", ""}, {"below/y", "x\n"}}));
  EXPECT_EQ(disk.after_cut(Unsynced::dropped, dice), DiskModel::State());
  EXPECT_EQ(disk.after_cut(Unsynced::cut_off, dice),
            (DiskModel::State{{"name", ""}, {"below/", ""}, {"below/y", ""}}));
  EXPECT_EQ(disk.after_cut(Unsynced::zero_filled, dice).at("name"), std::string(6, '\0'));
}

TEST(PowerCuts, LeaveWhatWasFlushedWithItsFolder) {
  const test::TemporaryFolder folder;
  DiskModel disk(folder.path());
  for (const DiskEvent& event : test::recorded(
           folder.path(), "echo whole > new; sync new; mv new name; sync .; echo no > name"))
    disk.apply(event);
  std::mt19937 dice;
  EXPECT_EQ(disk.after_cut(Unsynced::dropped, dice), (DiskModel::State{{"name", "whole\n"}}));
  EXPECT_EQ(disk.after_cut(Unsynced::kept, dice), (DiskModel::State{{"name", "no\n"}}));
}

}  // namespace
}  // namespace eerie::manager
