#include "solver/run/run.hpp"

#include <gmock/gmock.h>

#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "tests/run/runs.hpp"

namespace eerie::run {
namespace {

using test::differences;
using test::run_in;
using test::short_impact;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// State, rates and lists at the end of an uninterrupted run.
io::Snapshot uninterrupted(const Scene& scene) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_in(folder, scene).summary.end, RunEnd::finished);
  return io::read_snapshot(folder / "final.hdf5");
}

TEST(Run, SameBitsForAnyNumberOfThreads) {
  for (const char* precision : {"float", "double"}) {
    const Scene scene = short_impact({{"numerics", {{"precision", precision}}}});
    const io::Snapshot one = uninterrupted(scene);
    EXPECT_GT(one.state.step, 200);
    for (const int threads : {2, 3, 7}) {
      const TemporaryFolder folder;
      RunOptions options;
      options.threads = threads;
      run_in(folder, scene, options);
      EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), one), IsEmpty())
          << threads << " threads, " << precision;
    }
  }
}

TEST(Run, SeedAndPrecisionDecideTheBits) {
  // Guards the tests of equal bits against comparing a thing with itself.
  const io::Snapshot one = uninterrupted(short_impact());
  EXPECT_THAT(differences(one, uninterrupted(short_impact({{"numerics", {{"seed", 2}}}}))),
              testing::Contains("Coordinates"));
  EXPECT_THAT(
      differences(one, uninterrupted(short_impact({{"numerics", {{"precision", "double"}}}}))),
      testing::Contains("Coordinates"));
}

TEST(Run, InterruptedBySteplimitEndsWithTheSameBits) {
  const Scene scene = short_impact();
  const TemporaryFolder folder;
  RunOptions options;
  options.max_steps = 47;  // no multiple of a cycle
  int parts = 1;
  while (run_in(folder, scene, options).summary.end == RunEnd::step_limit) ++parts;
  EXPECT_GE(parts, 4);
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

TEST(Run, EveryOptionalLawKeepsItsBitsOverInterruptionsAndThreads) {
  const nlohmann::json laws[] = {
      {{"material", {{"energy", "integrated"}}},
       {"numerics",
        {{"smoothing", "evolving"}, {"integrator", "leapfrog-pece"}, {"gradient", "plain"}}}},
      {{"material",
        {{"rheology", "lundborg"},
         {"fracture", "grady-kipp"},
         {"lundborg", {{"Y_0_Pa", 1e3}}},
         {"grady_kipp", {{"k_per_m3", 1e20}}}}},
       {"numerics", {{"artificial_stress", 0.3}, {"kernel", "wendland-c2"}}},
       {"environment",
        {{"gravity_m_per_s2", {0, 0, -1e-6}},
         {"walls", {{{"face", "z_low"}, {"at_m", -60}, {"kind", "rough"}}}}}}},
      {{"numerics", {{"scheme", "shear-free"}}},
       {"environment", {{"walls", {{{"face", "z_low"}, {"at_m", -60}, {"kind", "rough"}}}}}}},
      {{"numerics", {{"scheme", "closing-voids"}}}},
      {{"numerics", {{"scheme", "closing-gaps"}}}},
      {{"material", {{"energy", "integrated"}}},
       {"numerics",
        {{"scheme", "closing-gaps"}, {"smoothing", "evolving"}, {"viscosity", "shear-free"}}}},
      {{"numerics", {{"scheme", "viscosity-50000"}}},
       {"material", {{"drucker_prager", {{"pressure", "total"}}}}}}};
  for (nlohmann::json changes : laws) {
    changes["end"]["time_s"] = 150;
    const Scene scene = short_impact(changes);
    const io::Snapshot whole = uninterrupted(scene);
    const TemporaryFolder folder;
    RunOptions options;
    options.threads = 3;
    options.max_steps = 47;
    int parts = 1;
    while (run_in(folder, scene, options).summary.end == RunEnd::step_limit) ++parts;
    EXPECT_GE(parts, 3);
    EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), whole), IsEmpty()) << changes;
  }
}

TEST(Run, StoppedByItsCallerEndsWithTheSameBits) {
  const Scene scene = short_impact();
  const TemporaryFolder folder;
  int cycles = 0;
  RunOptions stopping;
  stopping.on_progress = [&](const Progress&) { ++cycles; };
  stopping.stop = [&] { return cycles > 13; };
  EXPECT_EQ(run_in(folder, scene, stopping).summary.end, RunEnd::stopped);
  const auto told = run_in(folder, scene);
  EXPECT_EQ(told.summary.end, RunEnd::finished);
  EXPECT_THAT(told.notes, ElementsAre(HasSubstr("going on from")));
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

TEST(Run, DoneAtOnceWhenStoppedBeforeItsFirstCycle) {
  const Scene scene = short_impact();
  const TemporaryFolder folder;
  RunOptions stopping;
  stopping.stop = [] { return true; };
  EXPECT_EQ(run_in(folder, scene, stopping).summary.progress.step, 0);
  run_in(folder, scene, stopping);  // and again, from the checkpoint
  run_in(folder, scene);
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

TEST(Run, TotalsOfTheStartSurviveAnInterruption) {
  const Scene scene = short_impact();
  const TemporaryFolder whole, parts;
  const RunSummary one = run_in(whole, scene).summary;
  RunOptions options;
  options.max_steps = 100;
  run_in(parts, scene, options);
  const RunSummary two = run_in(parts, scene).summary;
  EXPECT_EQ(two.first_totals.angular_momentum, one.first_totals.angular_momentum);
  EXPECT_EQ(two.first_totals.potential_energy, one.first_totals.potential_energy);
  EXPECT_EQ(two.last_totals.kinetic_energy, one.last_totals.kinetic_energy);
  EXPECT_EQ(two.progress.particle_steps, one.progress.particle_steps);
  EXPECT_LT(two.steps_here, one.steps_here);
}

TEST(Run, PassesOverATornCheckpointWithANote) {
  const Scene scene = short_impact();
  const TemporaryFolder folder;
  RunOptions options;
  options.max_steps = 100;
  run_in(folder, scene, options);
  std::filesystem::resize_file(folder / "checkpoint.hdf5",
                               std::filesystem::file_size(folder / "checkpoint.hdf5") / 2);
  const auto told = run_in(folder, scene);
  EXPECT_EQ(told.summary.end, RunEnd::finished);
  EXPECT_THAT(told.notes,
              ElementsAre(testing::AllOf(HasSubstr("checkpoint.hdf5"), HasSubstr("passed over"))));
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

TEST(Run, PassesOverTheCheckpointOfAnotherScene) {
  const TemporaryFolder folder;
  RunOptions options;
  options.max_steps = 50;
  run_in(folder, short_impact({{"numerics", {{"seed", 2}}}}), options);
  const Scene scene = short_impact();
  const auto told = run_in(folder, scene);
  EXPECT_THAT(told.notes, ElementsAre(HasSubstr("belongs to another scene")));
  EXPECT_THAT(differences(io::read_snapshot(folder / "final.hdf5"), uninterrupted(scene)),
              IsEmpty());
}

TEST(Run, WritesSnapshotsAndHistoryWhenTheyFallDue) {
  const Scene scene = short_impact({{"output", {{"snapshot_interval_s", 100}}}});
  const TemporaryFolder folder;
  const auto told = run_in(folder, scene);
  const double cycle = told.summary.progress.dt * 10 * 1.5;  // no longer than this
  for (int n = 0; n < 4; ++n) {
    const double time =
        io::read_snapshot(folder / ("snapshot_000" + std::to_string(n) + ".hdf5").c_str())
            .state.time;
    EXPECT_GE(time, 100 * n);
    EXPECT_LT(time, 100 * n + cycle);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "snapshot_0004.hdf5"));  // that is final.hdf5
  // Times of steps are added up: rounding.
  EXPECT_NEAR(io::read_snapshot(folder / "final.hdf5").state.time, 400, 1e-9);
  ASSERT_EQ(told.history.size(), 8u);
  for (std::size_t n = 0; n < 8; ++n) {
    EXPECT_GE(told.history[n], 50.0 * static_cast<double>(n + 1) * (1 - 1e-12));
    EXPECT_LT(told.history[n], 50.0 * static_cast<double>(n + 1) + cycle);
  }
}

TEST(Run, SaysBeforeItKeepsAStateSoThatWhatBelongsToItLastsToo) {
  const Scene scene = short_impact({{"output", {{"checkpoint_interval_s", 0}}}});
  const TemporaryFolder folder;
  int asked = 0;
  RunOptions options;
  options.max_steps = 33;
  options.before_checkpoint = [&] { ++asked; };
  run_in(folder, scene, options);
  EXPECT_GE(asked, 3);  // a cycle has ten steps at most; the last checkpoint is that of the end
  options.max_steps = 0;
  options.before_checkpoint = [&] {
    asked = 0;
    EXPECT_FALSE(std::filesystem::exists(folder / "final.hdf5"));
  };
  run_in(folder, scene, options);
  EXPECT_EQ(asked, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "final.hdf5"));
}

TEST(Run, AnInterruptedRunWritesTheSameSnapshots) {
  const Scene scene = short_impact({{"output", {{"snapshot_interval_s", 100}}}});
  const TemporaryFolder whole, parts;
  run_in(whole, scene);
  RunOptions options;
  options.max_steps = 33;
  while (run_in(parts, scene, options).summary.end != RunEnd::finished) continue;
  for (const char* name : {"snapshot_0000.hdf5", "snapshot_0001.hdf5", "snapshot_0002.hdf5",
                           "snapshot_0003.hdf5", "final.hdf5"})
    EXPECT_EQ(read_file(parts / name), read_file(whole / name)) << name;
}

TEST(Run, AFinishedRunHasNothingLeftToDo) {
  const Scene scene = short_impact();
  const TemporaryFolder folder;
  run_in(folder, scene);
  const io::Snapshot before = io::read_snapshot(folder / "final.hdf5");
  const auto told = run_in(folder, scene);
  EXPECT_EQ(told.summary.end, RunEnd::finished);
  EXPECT_EQ(told.summary.steps_here, 0);
  std::vector<std::string> changed = differences(io::read_snapshot(folder / "final.hdf5"), before);
  EXPECT_THAT(changed, IsEmpty());
}

TEST(Run, AFolderThatCannotBeMadeIsNamed) {
  RunOptions options;
  options.directory = "/proc/eerie/run";
  try {
    run_impact(short_impact(), options);
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/proc/eerie/run"));
  }
}

TEST(Run, ThatFailsLeavesItsLastGoodCheckpointFromWhichItFailsAgainAlike) {
  // Ten times the sound speed, no viscosity, steps three times too long.
  const Scene scene = short_impact({{"impact", {{"v_imp_cm_per_s", 3000}, {"theta_imp_deg", 0}}},
                                    {"numerics",
                                     {{"scheme", "libersky-petschek-2018"},
                                      {"cfl", 0.9},
                                      {"viscosity_alpha", 0},
                                      {"viscosity_beta", 0}}},
                                    {"output", {{"history_interval_s", 1}}}});
  const TemporaryFolder folder;
  const auto failure = [&] {
    try {
      run_in(folder, scene);
    } catch (const NumericalError& error) {
      return error;
    }
    return NumericalError("nothing failed", -1, -1, "");
  };
  const NumericalError first = failure();
  EXPECT_THAT(first.what(), HasSubstr((folder / "last_good.hdf5").string()));
  const io::Snapshot good =
      io::read_snapshot(folder / "last_good.hdf5");  // finite, or it would not read
  ASSERT_TRUE(good.rates && good.restart);
  EXPECT_LE(good.state.step, first.step);
  std::filesystem::copy_file(folder / "last_good.hdf5", folder / "checkpoint.hdf5");
  const NumericalError second = failure();
  EXPECT_EQ(second.kind, first.kind);
  EXPECT_EQ(second.step, first.step);
  EXPECT_EQ(second.particle_id, first.particle_id);
}

TEST(Run, GoesOnUntilNothingWillMeetAndEndsAtTheSameMomentWhenInterrupted) {
  const Scene scene = short_impact({{"end", {{"time_s", 90}, {"latest_s", 120}}}});
  RunOptions options;
  std::vector<double> asked;
  options.will_meet = [&](const io::Snapshot& s) {
    asked.push_back(s.state.time);
    return s.state.time <= 95;
  };
  const TemporaryFolder whole, pieces;
  EXPECT_NEAR(run_in(whole, scene, options).summary.progress.time, 96, 1e-9);
  ASSERT_EQ(asked.size(), 3u);  // every thirtieth of the end time
  EXPECT_NEAR(asked[0], 90, 1e-9);
  EXPECT_NEAR(asked[2], 96, 1e-9);
  options.max_steps = 11;
  while (run_in(pieces, scene, options).summary.end == RunEnd::step_limit) continue;
  EXPECT_THAT(differences(io::read_snapshot(pieces / "final.hdf5"),
                          io::read_snapshot(whole / "final.hdf5")),
              IsEmpty());
}

TEST(Run, WritesItsSnapshotsWhileItWaits) {
  const Scene scene = short_impact({{"numerics", {{"gravity_tolerance", 1e-5}}},
                                    {"end", {{"time_s", 60}, {"latest_s", 66}}},
                                    {"output", {{"snapshot_interval_s", 2}}}});
  RunOptions options;
  options.will_meet = [](const io::Snapshot&) { return true; };
  const TemporaryFolder folder;
  run_in(folder, scene, options);
  // The questions at 60, 62 and 64 s fall on moments of a snapshot; the end at 66 s is final.hdf5.
  for (const char* name : {"snapshot_0029.hdf5", "snapshot_0030.hdf5", "snapshot_0031.hdf5",
                           "snapshot_0032.hdf5", "final.hdf5"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_FALSE(std::filesystem::exists(folder / "snapshot_0033.hdf5"));
}

TEST(Run, EndsAtTheLatestTimeWhateverWillMeet) {
  const Scene scene = short_impact({{"end", {{"time_s", 60}, {"latest_s", 67}}}});
  RunOptions options;
  options.will_meet = [](const io::Snapshot&) { return true; };
  const TemporaryFolder folder;
  const RunSummary summary = run_in(folder, scene, options).summary;
  EXPECT_NEAR(summary.progress.time, 67, 1e-9);
  EXPECT_EQ(summary.reason, EndReason::latest_time);
}

TEST(Run, EndsOnceItHasSettledWithTheSameBitsAndTheSameStepsAsOneThatGoesOn) {
  // Cycles shorter than the 5 s between two looks.
  const nlohmann::json steps_of = {{"gravity_tolerance", 1e-5}};
  const Scene going_on = short_impact({{"numerics", steps_of}, {"end", {{"time_s", 60}}}});
  const Scene settling = short_impact(
      {{"numerics", steps_of}, {"end", {{"time_s", 60}, {"settled", {{"window_s", 40}}}}}});
  RunOptions options;
  std::vector<double> looks;
  options.look = [&](const io::Snapshot& s, const LookQuestion&) -> LookAnswer {
    looks.push_back(s.state.time);
    if (s.state.time > 32) return End{};
    return GoOn{};
  };
  const TemporaryFolder whole, pieces;
  const RunSummary ended = run_in(whole, settling, options).summary;
  EXPECT_EQ(ended.reason, EndReason::settled);
  EXPECT_EQ(looks.size(), 7u);  // eight in a window, the first after an eighth of it
  EXPECT_NEAR(ended.progress.time, 35, 3);

  // Looking changes no step: a run that goes on passes the same state.
  RunOptions steps;
  steps.max_steps = ended.progress.step;
  const TemporaryFolder other;
  const RunSummary same = run_in(other, going_on, steps).summary;
  EXPECT_EQ(same.progress.step, ended.progress.step);
  EXPECT_EQ(same.progress.time, ended.progress.time);

  looks.clear();
  options.max_steps = 11;
  while (run_in(pieces, settling, options).summary.end == RunEnd::step_limit) continue;
  EXPECT_EQ(looks.size(), 7u);
  EXPECT_THAT(differences(io::read_snapshot(pieces / "final.hdf5"),
                          io::read_snapshot(whole / "final.hdf5")),
              IsEmpty());
}

TEST(Run, ThatEndedBeforeItsResultWasNotedEndsAgainAtOnceForTheSameReason) {
  const auto scene = [](double end_s, double latest_s) {
    return short_impact(
        {{"end", {{"time_s", end_s}, {"latest_s", latest_s}, {"settled", {{"window_s", 160}}}}}});
  };
  struct Case {
    double end_s, latest_s, settles_at_s, meets_until_s;
    EndReason reason;
  };
  // A look every 20 s; whether remnants will meet is asked every 3 s, and 5 s, from the end on.
  for (const Case& c :
       {Case{150, 0, 70, 0, EndReason::settled}, Case{150, 0, 1000, 0, EndReason::end_time},
        Case{120, 0, 120, 0, EndReason::settled}, Case{90, 300, 1000, 100, EndReason::end_time},
        Case{90, 300, 110, 1000, EndReason::settled},
        Case{90, 120, 1000, 1000, EndReason::latest_time}}) {
    RunOptions options;
    options.look = [&](const io::Snapshot& s, const LookQuestion&) -> LookAnswer {
      if (s.state.time >= c.settles_at_s) return End{};
      return GoOn{};
    };
    options.will_meet = [&](const io::Snapshot& s) { return s.state.time < c.meets_until_s; };
    const TemporaryFolder folder;
    const RunSummary first = run_in(folder, scene(c.end_s, c.latest_s), options).summary;
    EXPECT_EQ(first.reason, c.reason) << c.end_s << ' ' << c.settles_at_s;
    const RunSummary again = run_in(folder, scene(c.end_s, c.latest_s), options).summary;
    EXPECT_EQ(again.reason, first.reason) << c.end_s << ' ' << c.settles_at_s;
    EXPECT_EQ(again.steps_here, 0) << c.end_s << ' ' << c.settles_at_s;
    EXPECT_EQ(again.last.state.time, first.last.state.time);
  }
}

TEST(Run, DoesNotLookAtRemnantsWhereSettlingIsOff) {
  const Scene scene = short_impact({{"end", {{"time_s", 30}}}});
  RunOptions options;
  options.look = [](const io::Snapshot&, const LookQuestion&) -> LookAnswer {
    throw std::logic_error("looked");
  };
  const TemporaryFolder folder;
  const RunSummary summary = run_in(folder, scene, options).summary;
  EXPECT_EQ(summary.reason, EndReason::end_time);
}

}  // namespace
}  // namespace eerie::run
