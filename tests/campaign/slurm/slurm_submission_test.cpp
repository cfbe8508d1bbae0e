#include <gmock/gmock.h>

#include "campaign/manager/waiting/try_later.hpp"
#include "campaign/slurm/slurm_scheduler.hpp"
#include "tests/campaign/slurm/slurm_scheduler_fixture.hpp"

namespace eerie::slurm {
namespace {
using test::FakeSlurm;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

TEST_F(ASlurmScheduler, ThatSbatchRefusesSaysWhyAndLeavesNothing) {
  SlurmScheduler s = scheduler();
  const auto two = tasks(2);
  slurm->next_sbatch = FakeSlurm::Sbatch::refuses;
  try {
    s.start(two);
    FAIL() << "started";
  } catch (const manager::SchedulerUnavailable& error) {
    EXPECT_THAT(error.what(), HasSubstr("Invalid account"));
  }
  EXPECT_EQ(batch_folders(), 0u);
  EXPECT_FALSE(s.holds(two[0]));
  slurm->next_sbatch = FakeSlurm::Sbatch::takes;
  EXPECT_THAT(s.start(two), SizeIs(2));
}

std::chrono::seconds refused_patience(SlurmScheduler& s, std::span<const manager::Task> tasks) {
  try {
    s.start(tasks);
  } catch (const manager::TryLater& error) {
    EXPECT_THAT(error.what(), HasSubstr("QOSMaxSubmitJobPerUserLimit"));
    return error.patience;
  }
  ADD_FAILURE() << "started";
  return {};
}

TEST_F(ASlurmScheduler, ThatIsRefusedTriesLaterAndWithSmallerArraysUntilOneIsTaken) {
  profile.max_array_size = 100;
  slurm->next_sbatch = FakeSlurm::Sbatch::refuses;
  slurm->refusal =
      "Batch job submission failed: Job violates accounting/QOS policy (job submit limit, "
      "QOSMaxSubmitJobPerUserLimit)";
  SlurmScheduler s = scheduler();
  const auto eight = tasks(8);
  const std::span<const manager::Task> all(eight);
  EXPECT_EQ(refused_patience(s, all), 10s);
  EXPECT_EQ(s.free_slots(), 0u) << "before the time that it waits is over";
  EXPECT_EQ(refused_patience(s, all.first(4)), 20s);
  EXPECT_EQ(refused_patience(s, all.first(2)), 40s);
  for (int k = 0; k < 10; ++k) refused_patience(s, all.first(1));
  EXPECT_EQ(refused_patience(s, all.first(1)), 600s);
  slurm->next_sbatch = FakeSlurm::Sbatch::takes;
  const std::size_t calls = slurm->calls_of("sbatch").size();
  s.start(all.first(3));
  EXPECT_THAT(slurm->calls_of("sbatch")[calls], Contains("--array=0-0"));
  s.start(all.subspan(3, 4));
  EXPECT_THAT(slurm->calls_of("sbatch").back(), Contains("--array=0-3")) << "it dares more again";
}

TEST_F(ASlurmScheduler, ConcludesNothingWhileSqueueMayNotListANewJobYet) {
  profile.listed_within_s = 3600;
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  slurm->answers_before = 20;
  s.start(one);
  for (int k = 0; k < 20; ++k) EXPECT_THAT(s.wait(0ms), IsEmpty());
  EXPECT_TRUE(s.holds(one[0]));
  slurm->forget_all();  // it was listed: now its absence means something
  s.wait(0ms);
  EXPECT_THAT(s.wait(0ms), SizeIs(1));
  EXPECT_THAT(slurm->calls_of("sbatch"), SizeIs(1));
}

TEST_F(ASlurmScheduler, TakesTheResultOfAJobThatWasOverBeforeItWasListed) {
  profile.listed_within_s = 3600;
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  slurm->answers_before = 1000;
  s.start(one);
  finish(one[0]), note(one[0], 0);
  EXPECT_THAT(s.wait(0ms), SizeIs(1));
  EXPECT_FALSE(s.holds(one[0]));
}

TEST_F(ASlurmScheduler, DoesNotRepeatASubmissionThatFailedAfterItWasTakenAndIsListedLate) {
  profile.listed_within_s = 3600;
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  slurm->next_sbatch = FakeSlurm::Sbatch::complains_after_taking;
  slurm->answers_before = 9;
  EXPECT_THROW(s.start(one), manager::SchedulerUnavailable);
  for (int k = 0; k < 12; ++k) EXPECT_TRUE(s.holds(one[0]));
  EXPECT_EQ(read_file(batch_folder() / "slurm_id"), "1\n");
  EXPECT_THAT(slurm->calls_of("sbatch"), SizeIs(1));
}

TEST_F(ASlurmScheduler, FollowsAJobToTheClusterThatSbatchNames) {
  slurm->cluster = "east";
  const auto two = tasks(2);
  scheduler().start(two);
  EXPECT_EQ(read_file(batch_folder() / "slurm_id"), "1;east\n");
  SlurmScheduler second = scheduler();
  for (int k = 0; k < 5; ++k) EXPECT_TRUE(second.holds(two[0]));
  EXPECT_THAT(slurm->calls_of("squeue").back(), Contains("--clusters=east"));
  second.stop(two, manager::StopKind::at_once);
  EXPECT_THAT(slurm->calls_of("scancel"),
              ElementsAre(ElementsAre("scancel", "--clusters=east", "1_[0-1]")));
  EXPECT_TRUE(slurm->jobs[1].states.empty());
}

TEST_F(ASlurmScheduler, FindsASubmissionThatWasTakenThoughSbatchFailed) {
  for (const auto how :
       {FakeSlurm::Sbatch::times_out_after_taking, FakeSlurm::Sbatch::complains_after_taking,
        FakeSlurm::Sbatch::prints_nothing_we_know}) {
    SlurmScheduler s = scheduler();
    const auto one = tasks(1);
    slurm->next_sbatch = how;
    const int id = slurm->next_id;
    EXPECT_THAT(s.start(one), ElementsAre(fmt::format("slurm {}_0", id)));
    EXPECT_TRUE(s.holds(one[0]));
    fs::remove_all(batches_folder(folder.path()));
  }
}

TEST_F(ASlurmScheduler, LooksForASubmissionOfUnknownFateBeforeAnythingElse) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  slurm->next_sbatch = FakeSlurm::Sbatch::times_out_after_taking;
  slurm->squeue_answers = false;
  EXPECT_THROW(s.start(one), manager::SchedulerUnavailable);
  for (int k = 0; k < 10; ++k) EXPECT_TRUE(s.holds(one[0]));
  EXPECT_EQ(s.free_slots(), 0u);
  slurm->squeue_answers = true;
  EXPECT_TRUE(s.holds(one[0]));
  EXPECT_EQ(read_file(batch_folder() / "slurm_id"), "1\n");
  EXPECT_GT(s.free_slots(), 0u);
  slurm->set_state(1, 0, "RUNNING");
  finish(one[0]), note(one[0], 0);
  EXPECT_FALSE(s.holds(one[0]));
  EXPECT_THAT(s.wait(0ms), IsEmpty()) << "start() said that it was not started";
}

TEST_F(ASlurmScheduler, GivesUpASubmissionThatNeverArrived) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  slurm->next_sbatch = FakeSlurm::Sbatch::times_out;
  EXPECT_THROW(s.start(one), manager::SchedulerUnavailable);
  EXPECT_TRUE(s.holds(one[0]));
  EXPECT_EQ(s.free_slots(), 0u);
  int answers = 0;
  while (s.holds(one[0]) && answers < 100) ++answers;
  EXPECT_GE(answers, 2);
  EXPECT_LT(answers, 20);
  EXPECT_EQ(batch_folders(), 0u);
  EXPECT_GT(s.free_slots(), 0u);
}

TEST_F(ASlurmScheduler, WhoseManagerWasKilledBeforeSbatchStartsTheJobsAgain) {
  const auto one = tasks(1);
  Batch batch;
  batch.folder = batches_folder(folder.path()) / new_batch_id();
  batch.array = {{{one[0].job, one[0].directory}}};
  install_batch(batch, "/opt/eerie");
  SlurmScheduler s = scheduler();
  EXPECT_TRUE(s.holds(one[0]));
  int answers = 0;
  while (s.holds(one[0]) && answers < 100) ++answers;
  EXPECT_LT(answers, 20);
  EXPECT_EQ(batch_folders(), 0u);
}

TEST_F(ASlurmScheduler, WhoseManagerWasKilledAfterSbatchFindsTheBatchByItsName) {
  const auto two = tasks(2);
  scheduler().start(two);
  fs::remove(batch_folder() / "slurm_id");
  SlurmScheduler second = scheduler();
  for (int k = 0; k < 20; ++k) EXPECT_TRUE(second.holds(two[0]));
  EXPECT_EQ(read_file(batch_folder() / "slurm_id"), "1\n");
  second.stop(two, manager::StopKind::at_once);
  EXPECT_THAT(slurm->calls_of("scancel"), ElementsAre(ElementsAre("scancel", "1_[0-1]")));
}

TEST_F(ASlurmScheduler, WhoseManagerWasKilledLaterHoldsWhatIsLeft) {
  const auto three = tasks(3);
  scheduler().start(three);
  slurm->set_state(1, 0, "RUNNING");
  finish(three[0]), note(three[0], 0);
  slurm->forget(1, 1);
  SlurmScheduler second = scheduler();
  EXPECT_FALSE(second.holds(three[0]));
  EXPECT_FALSE(second.holds(three[1])) << "the second answer without it";
  EXPECT_TRUE(second.holds(three[2]));
  EXPECT_THAT(second.wait(0ms), IsEmpty());
  EXPECT_EQ(batch_folders(), 1u);
}

TEST_F(ASlurmScheduler, WhoseManagerWasKilledWhileItMadeABatchRemovesTheRest) {
  fs::create_directories(batches_folder(folder.path()) / "half");
  install_text(batches_folder(folder.path()) / "half" / "batch.sh", "#!/bin/sh\n");
  scheduler();
  EXPECT_EQ(batch_folders(), 0u);
}

TEST_F(ASlurmScheduler, DoesNotForgetABatchWhoseManifestItCannotRead) {
  scheduler().start(tasks(1));
  install_text(batch_folder() / "manifest.json", R"({"version": 2})");
  EXPECT_THROW(scheduler(), EnvironmentError);
  EXPECT_EQ(batch_folders(), 1u);
}

}  // namespace
}  // namespace eerie::slurm
