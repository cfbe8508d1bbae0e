#include "campaign/process/environment.hpp"

#include <gmock/gmock.h>

namespace eerie::process {
namespace {

TEST(Environment, OfWorkersHasNoSettingsOfOpenMPButHowThreadsWait) {
  EXPECT_TRUE(steers_openmp("OMP_PROC_BIND=true"));
  EXPECT_TRUE(steers_openmp("OMP_NUM_THREADS=4"));
  EXPECT_TRUE(steers_openmp("GOMP_CPU_AFFINITY=0"));
  EXPECT_FALSE(steers_openmp("OMP_WAIT_POLICY=active"));
  EXPECT_FALSE(steers_openmp("GOMP_SPINCOUNT=5"));
  EXPECT_FALSE(steers_openmp("HOME=/home/OMP_"));
}

TEST(Environment, OfSlurmSaysWhereTheClusterIsAndNothingElse) {
  for (const char* variable : {"SBATCH_PARTITION=x", "SBATCH_WAIT=1", "SLURM_JOB_ID=1",
                               "SLURM_CLUSTERS=east", "SQUEUE_STATES=R", "SCANCEL_STATE=R"})
    EXPECT_TRUE(steers_slurm(variable)) << variable;
  for (const char* variable : {"SLURM_CONF=/etc/slurm.conf", "SLURM_JWT=secret", "PATH=/bin"})
    EXPECT_FALSE(steers_slurm(variable)) << variable;
}

TEST(Environment, NamesWhatIsLeftOut) {
  ::setenv("OMP_PLACES", "cores", 1);
  const Environment found = environment_for_workers();
  ::unsetenv("OMP_PLACES");
  EXPECT_THAT(found.left_out, testing::Contains("OMP_PLACES"));
  EXPECT_EQ(found.passed_on.back(), nullptr);
}

}  // namespace
}  // namespace eerie::process
