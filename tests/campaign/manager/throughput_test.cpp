#include "campaign/manager/throughput.hpp"

#include <gtest/gtest.h>

namespace eerie::manager {
namespace {

using std::chrono::seconds;
const Throughput::Clock::time_point start{};

job_folder::WorkerProgress at(double time_s, double particle_steps) {
  job_folder::WorkerProgress p;
  p.time_s = time_s;
  p.end_time_s = 1000;
  p.expected_end_s = 100;
  p.particle_steps = particle_steps;
  return p;
}

TEST(Throughput, IsUnknownBeforeAnythingWasMeasured) {
  Throughput t(1e6, 0);
  EXPECT_EQ(t.particle_steps_per_s(), 0);
  EXPECT_LT(t.eta_s(), 0);
}

TEST(Throughput, AddsUpTheStepsOfAllWorkers) {
  Throughput t(4e6, 0);
  t.started(1, 1e6);
  t.started(2, 1e6);
  t.progressed(1, at(0, 0));
  t.progressed(2, at(0, 0));
  t.sample(start);
  t.progressed(1, at(50, 5e5));
  t.progressed(2, at(25, 2.5e5));
  t.sample(start + seconds(10));
  EXPECT_DOUBLE_EQ(t.particle_steps_per_s(), 7.5e4);
  // left: 0.5e6 + 0.75e6 of the running ones, 2e6 of the waiting ones
  EXPECT_NEAR(t.eta_s(), 3.25e6 / 7.5e4, 1e-6);
}

TEST(Throughput, ExpectsATenthMoreOfARunThatShouldBeOver) {
  Throughput t(1e6, 0);
  t.started(1, 1e6);
  t.progressed(1, at(0, 0));
  t.sample(start);
  t.progressed(1, at(150, 2e6));
  t.sample(start + seconds(10));
  EXPECT_NEAR(t.eta_s(), 0.1 * 2e6 / 2e5, 1e-9);
}

TEST(Throughput, DoesNotCountWhatAnEarlierAttemptDid) {
  Throughput t(1e6, 0);
  t.started(1, 1e6);
  t.progressed(1, at(50, 5e5));
  t.sample(start);
  t.sample(start + seconds(1));
  EXPECT_EQ(t.particle_steps_per_s(), 0);
}

TEST(Throughput, CountsOnWhereAWorkerWentBackToACheckpoint) {
  Throughput t(1e6, 0);
  t.started(1, 1e6);
  t.progressed(1, at(50, 5e5));  // by a worker that was killed
  t.progressed(1, at(20, 2e5));
  t.sample(start);
  t.progressed(1, at(30, 3e5));
  t.sample(start + seconds(10));
  EXPECT_DOUBLE_EQ(t.particle_steps_per_s(), 1e4);
  EXPECT_NEAR(t.eta_s(), 70, 1e-9);
}

TEST(Throughput, CorrectsTheFormulaByFinishedJobs) {
  Throughput t(2e6, 0.5);  // jobs took twice the steps expected
  t.started(1, 1e6);
  t.progressed(1, at(0, 0));
  t.sample(start);
  t.progressed(1, at(1, 1e5));
  t.sample(start + seconds(1));
  EXPECT_NEAR(t.eta_s(), (2e6 * 0.99 + 2e6) / 1e5, 1e-6);
}

TEST(Throughput, KeepsAJobThatStartsAgainInTheEstimate) {
  Throughput t(1e6, 0);
  t.started(1, 1e6);
  t.progressed(1, at(0, 0));
  t.sample(start);
  t.progressed(1, at(50, 5e5));
  t.sample(start + seconds(1));
  t.ended(1, false);
  EXPECT_NEAR(t.eta_s(), 1e6 / 5e5, 1e-9);
}

}  // namespace
}  // namespace eerie::manager
