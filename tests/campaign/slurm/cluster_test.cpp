#include "campaign/slurm/cluster.hpp"

#include <gmock/gmock.h>

#include "tests/campaign/slurm/fake_slurm.hpp"

namespace eerie::slurm {
namespace {
using testing::Contains;
using testing::Not;
using testing::StartsWith;

Batch small_batch(const std::string& folder = "/jobs/batches/b1") {
  Batch batch;
  batch.folder = folder;
  batch.array.resize(5);
  return batch;
}

TEST(SbatchLine, SaysAllThatTheManagerReliesOn) {
  const auto words = sbatch_words({}, small_batch());
  EXPECT_EQ(words.front(), "sbatch");
  EXPECT_EQ(words.back(), "/jobs/batches/b1/batch.sh");
  for (const char* word : {"--parsable", "--array=0-4", "--requeue", "--open-mode=append",
                           "--signal=B:USR1@120", "--job-name=eerie-b1", "--cpus-per-task=1",
                           "--ntasks=1", "--output=/jobs/batches/b1/output_%a.txt"})
    EXPECT_THAT(words, Contains(word));
  for (const char* option :
       {"--partition", "--account", "--qos", "--constraint", "--mem", "--time"})
    EXPECT_THAT(words, Not(Contains(StartsWith(option))));
}

TEST(SbatchLine, HasTheProfilesFieldsAndThenItsOptions) {
  SlurmProfile p;
  p.partition = "long", p.account = "ab12", p.qos = "low", p.constraint = "a&b", p.memory = "2G";
  p.time_limit = std::chrono::seconds(100'000);
  p.cpus_per_task = 8;
  p.signal_before_end_s = 300;
  p.extra_sbatch_options = {"--exclude=n17"};
  const auto words = sbatch_words(p, small_batch());
  for (const char* word :
       {"--partition=long", "--account=ab12", "--qos=low", "--constraint=a&b", "--mem=2G",
        "--time=1-03:46:40", "--cpus-per-task=8", "--signal=B:USR1@300"})
    EXPECT_THAT(words, Contains(word));
  EXPECT_EQ(words[words.size() - 2], "--exclude=n17");
}

TEST(SbatchLine, GuardsPercentSignsOfTheFolder) {
  EXPECT_THAT(sbatch_words({}, small_batch("/100%a/b")),
              Contains("--output=/100%%a/b/output_%a.txt"));
}

TEST(ACluster, IsAskedForItsLargestArrayOnceUnlessTheProfileSaysIt) {
  test::FakeSlurm slurm;
  Cluster asked({}, slurm);
  EXPECT_EQ(asked.array_size(), 4u);
  EXPECT_EQ(asked.array_size(), 4u);
  EXPECT_EQ(slurm.calls_of("scontrol").size(), 1u);
  SlurmProfile profile;
  profile.max_array_size = 77;
  EXPECT_EQ(Cluster(profile, slurm).array_size(), 77u);
  EXPECT_EQ(slurm.calls_of("scontrol").size(), 1u);
}

TEST(ACluster, WithMoreBatchesThanACommandLineHoldsIsAskedForAllJobs) {
  test::FakeSlurm slurm;
  slurm.jobs[1] = {"eerie-17", {{0, "RUNNING"}}};
  slurm.jobs[2] = {"another", {{0, "RUNNING"}}};
  std::vector<std::string> names;
  for (int k = 0; k < 5000; ++k) names.push_back(fmt::format("eerie-{}", k));
  Cluster cluster({}, slurm);
  const auto queue = cluster.queue(names);
  ASSERT_TRUE(queue);
  EXPECT_EQ(queue->size(), 1u);
  EXPECT_THAT(slurm.calls_of("squeue")[0], Not(Contains(StartsWith("--name"))));
}

TEST(ACluster, ListsOnlyJobsOfTheseNames) {
  test::FakeSlurm slurm;
  slurm.jobs[1] = {"eerie-b1", {{0, "RUNNING"}}};
  slurm.jobs[2] = {"eerie-b2", {{0, "RUNNING"}}};
  Cluster cluster({}, slurm);
  const auto queue = cluster.queue({"eerie-b2"});
  ASSERT_TRUE(queue);
  EXPECT_EQ(queue->size(), 1u);
  EXPECT_TRUE(queue->contains(2));
  EXPECT_THAT(slurm.calls_of("squeue")[0], Contains("--name=eerie-b2"));
  slurm.squeue_answers = false;
  EXPECT_EQ(cluster.queue({"eerie-b2"}), std::nullopt);
}

}  // namespace
}  // namespace eerie::slurm
