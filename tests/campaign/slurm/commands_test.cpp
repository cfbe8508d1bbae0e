#include "campaign/slurm/commands.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace eerie::slurm {
namespace {
using namespace std::chrono_literals;
using testing::HasSubstr;

CommandEnd run(const std::vector<std::string>& words, std::chrono::milliseconds limit = 30s) {
  return ChildCommands().run(words, limit);
}

TEST(ChildCommands, GiveOutputErrorsAndCode) {
  const CommandEnd end = run({"sh", "-c", "echo out; echo err >&2; exit 3"});
  EXPECT_EQ(end.exit_code, 3);
  EXPECT_FALSE(end.ok());
  EXPECT_EQ(end.out, "out\n");
  EXPECT_EQ(end.err, "err\n");
  EXPECT_EQ(end.complaint(), "err");
  EXPECT_TRUE(run({"true"}).ok());
}

TEST(ChildCommands, PassWordsAsTheyAre) {
  EXPECT_EQ(run({"printf", "%s|", "a b", "$HOME;'\"`id`", "*\n"}).out, "a b|$HOME;'\"`id`|*\n|");
}

TEST(ChildCommands, TakeMuchOutputOnBothSides) {
  const CommandEnd end =
      run({"sh", "-c", "head -c 3000000 /dev/zero; head -c 3000000 /dev/zero >&2"});
  EXPECT_EQ(end.out.size(), 3000000u);
  EXPECT_EQ(end.err.size(), 3000000u);
}

TEST(ChildCommands, EndOneThatTakesTooLongWithItsChildren) {
  const auto start = std::chrono::steady_clock::now();
  const CommandEnd end = run({"sh", "-c", "echo begun; sleep 1000 & sleep 1000"}, 300ms);
  EXPECT_LT(std::chrono::steady_clock::now() - start, 60s);
  EXPECT_TRUE(end.timed_out);
  EXPECT_FALSE(end.ok());
  EXPECT_EQ(end.out, "begun\n");
  EXPECT_THAT(end.complaint(), HasSubstr("in time"));
}

TEST(ChildCommands, SayWhyOneCannotBeStarted) {
  const CommandEnd end = run({"no-such-program-of-slurm"});
  EXPECT_FALSE(end.ok());
  EXPECT_THAT(end.complaint(), HasSubstr("no-such-program-of-slurm"));
}

TEST(ChildCommands, DoNotLetTheUsersDefaultsHideJobsOrReachWorkers) {
  constexpr const char* own_settings[] = {
      "SBATCH_PARTITION",    "SBATCH_EXPORT",     "SBATCH_CLUSTERS", "SLURM_CLUSTERS",
      "SLURM_CPUS_PER_TASK", "SLURM_MEM_PER_CPU", "OMP_PROC_BIND",   "OMP_NUM_THREADS"};
  ::setenv("SQUEUE_STATES", "RUNNING", 1);
  ::setenv("SCANCEL_STATE", "RUNNING", 1);
  ::setenv("SLURM_CONF", "/somewhere", 1);
  for (const char* name : own_settings) ::setenv(name, "1", 1);
  const std::string seen = run({"env"}).out;
  ::unsetenv("SQUEUE_STATES"), ::unsetenv("SCANCEL_STATE"), ::unsetenv("SLURM_CONF");
  for (const char* name : own_settings) {
    EXPECT_THAT(seen, testing::Not(HasSubstr(name)));
    ::unsetenv(name);
  }
  EXPECT_THAT(seen, testing::Not(HasSubstr("SQUEUE_STATES")));
  EXPECT_THAT(seen, testing::Not(HasSubstr("SCANCEL_STATE")));
  EXPECT_THAT(seen, HasSubstr("SLURM_CONF=/somewhere\n"));
}

TEST(ChildCommands, ComplainByTheEndOfWhatWasSaid) {
  CommandEnd end;
  end.exit_code = 4;
  EXPECT_THAT(end.complaint(), HasSubstr("code 4"));
  end.err = std::string(10000, 'x') + "the reason\n\n";
  EXPECT_LT(end.complaint().size(), 600u);
  EXPECT_THAT(end.complaint(), testing::EndsWith("the reason"));
}

}  // namespace
}  // namespace eerie::slurm
