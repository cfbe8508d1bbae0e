#include "campaign/slurm/slurm_scheduler.hpp"

#include <gmock/gmock.h>

#include "campaign/job_folder/worker_exit.hpp"
#include "tests/campaign/slurm/slurm_scheduler_fixture.hpp"

namespace eerie::slurm {
namespace {
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

TEST_F(ASlurmScheduler, SubmitsManyTasksAsOneArrayThatIsOnDiskBefore) {
  SlurmScheduler s = scheduler();
  EXPECT_THAT(s.start(tasks(3)), ElementsAre("slurm 1_0", "slurm 1_1", "slurm 1_2"));
  EXPECT_THAT(slurm->calls_of("sbatch"), SizeIs(1));
  EXPECT_THAT(slurm->calls_of("sbatch")[0], Contains("--array=0-2"));
  EXPECT_TRUE(slurm->manifest_came_first);
  EXPECT_EQ(read_file(batch_folder() / "slurm_id"), "1\n");
  for (const manager::Task& task : tasks(3)) EXPECT_TRUE(s.holds(task));
  EXPECT_FALSE(s.holds(tasks(4)[3]));
}

TEST_F(ASlurmScheduler, ReportsAResultWithWhatItCostAndForgetsTheBatch) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  slurm->set_state(1, 0, "RUNNING");
  finish(one[0]), note(one[0], 0);
  const auto ends = s.wait(0ms);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].job, 100);
  EXPECT_EQ(ends[0].exit_code, 0);
  EXPECT_EQ(ends[0].core_seconds, 12.5);
  EXPECT_EQ(ends[0].peak_memory_bytes, 1 << 20);
  EXPECT_FALSE(ends[0].lost);
  EXPECT_FALSE(s.holds(one[0]));
  EXPECT_EQ(batch_folders(), 0u);
  EXPECT_THAT(s.wait(0ms), IsEmpty());
}

TEST_F(ASlurmScheduler, GivesAWorkerOnePollToSayWhatItsResultCost) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  slurm->set_state(1, 0, "RUNNING");
  finish(one[0]);
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  const auto ends = s.wait(0ms);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].exit_code, 0);
  EXPECT_FALSE(ends[0].core_seconds);
}

TEST_F(ASlurmScheduler, ReportsAFailure) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  slurm->set_state(1, 0, "RUNNING");
  install_text(one[0].directory.failure(),
               job_folder::to_json(job_folder::Failure{"not-finite", 1, 2, "NaN"}).dump());
  note(one[0], 1);
  const auto ends = s.wait(0ms);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].exit_code, 1);
}

TEST_F(ASlurmScheduler, TakesAnIdThatVanishedWithAResultForDone) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  finish(one[0]);
  slurm->forget_all();
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  const auto ends = s.wait(0ms);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].exit_code, 0);
  EXPECT_FALSE(ends[0].lost);
}

TEST_F(ASlurmScheduler, TakesAnIdThatVanishedWithoutAWordForLostAndKeepsWhatItSaid) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  install_text(batch_folder() / "output_0.txt", "/opt/eerie: not found\n");
  slurm->forget_all();
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  const auto ends = s.wait(0ms);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_TRUE(ends[0].lost);
  EXPECT_EQ(ends[0].exit_code, -1);
  EXPECT_FALSE(s.holds(one[0]));
  EXPECT_THAT(read_file(one[0].directory.log()), HasSubstr("/opt/eerie: not found"));
}

TEST_F(ASlurmScheduler, ConcludesNothingFromOneEmptyAnswer) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  const auto before = std::exchange(slurm->jobs, {});
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  slurm->jobs = before;
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  slurm->forget_all();
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  EXPECT_TRUE(slurm->calls_of("squeue").size() >= 3);
  EXPECT_THAT(s.wait(0ms), SizeIs(1));
}

TEST_F(ASlurmScheduler, ConcludesNothingWhileSqueueFailsButTakesResults) {
  SlurmScheduler s = scheduler();
  const auto two = tasks(2);
  s.start(two);
  slurm->squeue_answers = false;
  slurm->forget_all();
  for (int k = 0; k < 20; ++k) EXPECT_THAT(s.wait(0ms), IsEmpty());
  EXPECT_TRUE(s.holds(two[0]));
  finish(two[1]), note(two[1], 0);
  EXPECT_THAT(s.wait(0ms), SizeIs(1));
  EXPECT_TRUE(s.holds(two[0]));
  EXPECT_FALSE(s.holds(two[1]));
}

TEST_F(ASlurmScheduler, TakesWordsItDoesNotKnowForStillThere) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  slurm->set_state(1, 0, "REVOKED_BY_THE_MOON");
  for (int k = 0; k < 5; ++k) EXPECT_THAT(s.wait(0ms), IsEmpty());
  EXPECT_TRUE(s.holds(one[0]));
}

TEST_F(ASlurmScheduler, WaitsForAPreemptedJobThatSlurmStartsAgain) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  slurm->set_state(1, 0, "RUNNING");
  note(one[0], job_folder::worker_stopped);
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  slurm->set_state(1, 0, "PENDING");
  for (int k = 0; k < 5; ++k) EXPECT_THAT(s.wait(0ms), IsEmpty());
  EXPECT_TRUE(s.holds(one[0]));
  slurm->set_state(1, 0, "RUNNING");
  finish(one[0]), note(one[0], 0);
  EXPECT_THAT(s.wait(0ms), SizeIs(1));
  EXPECT_THAT(slurm->calls_of("sbatch"), SizeIs(1));
}

TEST_F(ASlurmScheduler, ReportsAJobThatItsTimeLimitStoppedAsStopped) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  note(one[0], job_folder::worker_stopped);
  slurm->forget_all();
  s.wait(0ms);
  const auto ends = s.wait(0ms);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].exit_code, job_folder::worker_stopped);
  EXPECT_FALSE(ends[0].lost);
}

TEST_F(ASlurmScheduler, TellsBySignalHowAWorkerDied) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  slurm->set_state(1, 0, "COMPLETING");
  note(one[0], 128 + 9);
  const auto ends = s.wait(0ms);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].signal, 9);
  EXPECT_EQ(ends[0].exit_code, -1);
}

TEST_F(ASlurmScheduler, IgnoresNewsThatAreOlderThanTheSubmission) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  note(one[0], 134);
  install_text(one[0].directory.stop(), "");
  install_text(one[0].directory.failure(), job_folder::to_json(job_folder::Failure{}).dump());
  for (const fs::path& file :
       {one[0].directory.ended(), one[0].directory.stop(), one[0].directory.failure()})
    fs::last_write_time(file, fs::last_write_time(file) - 1h);
  s.start(one);
  slurm->set_state(1, 0, "RUNNING");
  for (int k = 0; k < 3; ++k) EXPECT_THAT(s.wait(0ms), IsEmpty());
  EXPECT_TRUE(s.holds(one[0]));
}

TEST_F(ASlurmScheduler, GivesBackACrashedJobOfAPackBeforeThePackEnds) {
  profile.minutes_per_array_task = 10;
  const auto three = tasks(3);
  {
    SlurmScheduler s = scheduler();
    EXPECT_THAT(s.start(three), ElementsAre("slurm 1_0", "slurm 1_0", "slurm 1_0"));
    slurm->set_state(1, 0, "RUNNING");
    note(three[0], 128 + 11);
    EXPECT_THAT(s.wait(0ms), SizeIs(1));
    EXPECT_FALSE(s.holds(three[0]));
    EXPECT_TRUE(s.holds(three[1]));
    // Should the array task start again, it leaves this job alone.
    EXPECT_THAT(read_released(*read_batch(batch_folder())), ElementsAre(100));
    s.start(std::span(three).first(1));
  }
  fs::remove(three[0].directory.ended());
  SlurmScheduler second = scheduler();
  EXPECT_TRUE(second.holds(three[0]));
  finish(three[0]), note(three[0], 0);
  slurm->set_state(2, 0, "RUNNING");
  EXPECT_FALSE(second.holds(three[0]));
  EXPECT_TRUE(second.holds(three[1]));
}

TEST_F(ASlurmScheduler, StopsWithCheckpointsByFilesAndCancelsOnlyWhatWaits) {
  SlurmScheduler s = scheduler();
  const auto two = tasks(2);
  s.start(two);
  slurm->set_state(1, 1, "RUNNING");
  s.wait(0ms);
  s.stop(two, manager::StopKind::with_checkpoint);
  for (const manager::Task& task : two) EXPECT_TRUE(fs::exists(task.directory.stop()));
  EXPECT_THAT(slurm->calls_of("scancel"),
              ElementsAre(ElementsAre("scancel", "--state=PENDING", "1_[0]")));
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  note(two[1], job_folder::worker_stopped);
  std::vector<std::int64_t> stopped;
  for (const manager::WorkerEnd& end : s.wait(0ms)) {
    EXPECT_EQ(end.exit_code, job_folder::worker_stopped);
    EXPECT_FALSE(end.lost);
    stopped.push_back(end.job);
  }
  EXPECT_THAT(stopped, testing::UnorderedElementsAre(100, 101));
}

TEST_F(ASlurmScheduler, StopsOneJobOfAPackWithoutTheOthers) {
  profile.minutes_per_array_task = 10;
  SlurmScheduler s = scheduler();
  const auto three = tasks(3);
  s.start(three);
  s.stop(std::span(three).subspan(1, 1), manager::StopKind::at_once);
  EXPECT_THAT(slurm->calls_of("scancel"), IsEmpty());
  EXPECT_FALSE(fs::exists(three[0].directory.stop()));
  EXPECT_TRUE(fs::exists(three[1].directory.stop()));
  s.stop(three, manager::StopKind::at_once);
  EXPECT_THAT(slurm->calls_of("scancel"), ElementsAre(ElementsAre("scancel", "1_[0]")));
}

TEST_F(ASlurmScheduler, StopsAtOnceWithoutBlameAndAsksAgainWhereSlurmDidNotListen) {
  SlurmScheduler s = scheduler();
  const auto one = tasks(1);
  s.start(one);
  slurm->set_state(1, 0, "RUNNING");
  slurm->scancel_answers = false;
  s.stop(one, manager::StopKind::at_once);
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  slurm->scancel_answers = true;
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  EXPECT_TRUE(slurm->jobs[1].states.empty());
  EXPECT_THAT(s.wait(0ms), IsEmpty());
  const auto ends = s.wait(0ms);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].exit_code, job_folder::worker_stopped);
  EXPECT_THAT(slurm->calls_of("scancel"), SizeIs(3));
}

TEST_F(ASlurmScheduler, TakesNewTasksOnceAQuarterOfItsQueueIsFree) {
  profile.max_queued = 8;
  profile.max_array_size = 100;
  SlurmScheduler s = scheduler();
  const auto eight = tasks(8);
  EXPECT_EQ(s.free_slots(), 8u);
  s.start(eight);
  EXPECT_EQ(s.free_slots(), 0u);
  slurm->forget(1, 0);
  s.wait(0ms), s.wait(0ms);
  EXPECT_EQ(s.free_slots(), 0u);
  slurm->forget(1, 1);
  s.wait(0ms), s.wait(0ms);
  EXPECT_EQ(s.free_slots(), 2u);
}

TEST_F(ASlurmScheduler, KeepsItsArraysBelowTheClustersLargest) {
  SlurmScheduler s = scheduler();
  EXPECT_EQ(s.free_slots(), 4u);  // MaxArraySize of the fake
  const auto names = s.start(tasks(6));
  EXPECT_EQ(names[3], "slurm 1_3");
  EXPECT_EQ(names[4], "slurm 2_0");
  EXPECT_THAT(slurm->calls_of("sbatch")[0], Contains("--array=0-3"));
  EXPECT_THAT(slurm->calls_of("sbatch")[1], Contains("--array=0-1"));
}

TEST_F(ASlurmScheduler, GivesBackWhatOnlyTheSecondSubmissionRefused) {
  slurm->refuse_from = 2;
  SlurmScheduler s = scheduler();
  const auto six = tasks(6);
  s.start(six);
  const auto ends = s.wait(0ms);
  ASSERT_THAT(ends, SizeIs(2));
  EXPECT_EQ(ends[0].exit_code, job_folder::worker_stopped);
  EXPECT_TRUE(s.holds(six[3]));
  EXPECT_FALSE(s.holds(six[4]));
  EXPECT_EQ(batch_folders(), 1u);
}

TEST_F(ASlurmScheduler, RefusesAFolderThatSbatchWouldMisread) {
  EXPECT_THROW(SlurmScheduler(profile, folder.path() / "a\\b", slurm, "/opt/eerie"), InputError);
  EXPECT_THROW(SlurmScheduler(profile, folder.path() / "a\nb", slurm, "/opt/eerie"), InputError);
  EXPECT_THROW(SlurmScheduler(profile, folder.path() / "a\xff", slurm, "/opt/eerie"), InputError);
}

}  // namespace
}  // namespace eerie::slurm
