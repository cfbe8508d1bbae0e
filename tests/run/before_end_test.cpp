#include <gmock/gmock.h>

#include "solver/run/checkpoints.hpp"
#include "tests/run/runs.hpp"

namespace eerie::run {
namespace {
namespace fs = std::filesystem;

using test::differences;
using test::run_in;
using test::short_impact;
using test::TemporaryFolder;
using testing::IsEmpty;

/// An impact that looks at itself every 20 s.
Scene until(double end_s) {
  return short_impact({{"end", {{"time_s", end_s}, {"settled", {{"window_s", 160}}}}}});
}

/// A run with a late end that goes on from where an early one did not depend on its end yet.
test::Told going_on(const TemporaryFolder& early, const TemporaryFolder& folder, const Scene& late,
                    const RunOptions& options = {}) {
  for (const auto& [from, to] :
       {std::pair(early / before_end_file, folder / checkpoint_file),
        std::pair(snapshot_path(early.path(), 0), snapshot_path(folder.path(), 0))}) {
    io::Snapshot saved = io::read_snapshot(from);
    saved.scene = late;
    io::write_snapshot(to, saved);
  }
  return run_in(folder, late, options);
}

TEST(BeforeEnd, IsTheLastStateThatARunWithALaterEndHasToo) {
  for (const double early_end : {90.0, 120.0, 133.7}) {
    const TemporaryFolder whole, early, folder;
    run_in(whole, until(250));
    run_in(early, until(early_end));
    const double kept_at = io::read_snapshot(early / before_end_file).state.time;
    EXPECT_LT(kept_at, early_end);
    EXPECT_GT(kept_at, 0.5 * early_end);
    going_on(early, folder, until(250));
    EXPECT_THAT(
        differences(io::read_snapshot(folder / final_file), io::read_snapshot(whole / final_file)),
        IsEmpty())
        << early_end;
    EXPECT_THAT(differences(io::read_snapshot(folder / before_end_file),
                            io::read_snapshot(whole / before_end_file)),
                IsEmpty());
  }
}

TEST(BeforeEnd, IsOneForARunThatWaitsForItsRemnantsToo) {
  const auto waits_until = [](double latest_s) {
    return short_impact({{"end", {{"time_s", 90}, {"latest_s", latest_s}}}});
  };
  RunOptions options;
  options.will_meet = [](const io::Snapshot&) { return true; };
  const TemporaryFolder whole, early, folder;
  EXPECT_EQ(run_in(whole, waits_until(180), options).summary.reason, EndReason::latest_time);
  EXPECT_EQ(run_in(early, waits_until(120), options).summary.reason, EndReason::latest_time);
  going_on(early, folder, waits_until(180), options);
  EXPECT_THAT(
      differences(io::read_snapshot(folder / final_file), io::read_snapshot(whole / final_file)),
      IsEmpty());
}

TEST(BeforeEnd, TheEndItselfIsNoSuchStateSinceItsLastCycleIsMadeToEndThere) {
  // Guards the test above: it would be simpler to go on from final.hdf5, and wrong.
  const TemporaryFolder whole, early, folder;
  run_in(whole, until(250));
  run_in(early, until(120));
  fs::copy_file(early / final_file, early / before_end_file, fs::copy_options::overwrite_existing);
  going_on(early, folder, until(250));
  EXPECT_THAT(
      differences(io::read_snapshot(folder / final_file), io::read_snapshot(whole / final_file)),
      testing::Contains("Coordinates"));
}

/// Softens at the first look that sees the end within 60 s, as those do that depend on it.
RunOptions softening_before(double end_s) {
  RunOptions options;
  options.look = [end_s](const io::Snapshot& now, const LookQuestion&) -> LookAnswer {
    if (end_s - now.state.time > 60) return GoOn{};
    return Soften{{0.5, false}};
  };
  options.end_matters = [end_s](const io::Snapshot& now, const LookQuestion&) {
    return end_s - now.state.time <= 60;
  };
  return options;
}

TEST(BeforeEnd, IsFromBeforeTheFirstLookThatTheEndDecided) {
  const TemporaryFolder whole, early, folder;
  run_in(whole, until(250), softening_before(250));
  run_in(early, until(150), softening_before(150));
  EXPECT_LT(io::read_snapshot(early / before_end_file).state.time, 100);
  going_on(early, folder, until(250), softening_before(250));
  EXPECT_THAT(
      differences(io::read_snapshot(folder / final_file), io::read_snapshot(whole / final_file)),
      IsEmpty());
}

TEST(BeforeEnd, IsTheSameAfterAnyInterruption) {
  const TemporaryFolder whole, parts;
  run_in(whole, until(150), softening_before(150));
  RunOptions options = softening_before(150);
  options.max_steps = 23;
  int runs = 1;
  while (run_in(parts, until(150), options).summary.end == RunEnd::step_limit) ++runs;
  EXPECT_GT(runs, 4);
  EXPECT_THAT(differences(io::read_snapshot(parts / before_end_file),
                          io::read_snapshot(whole / before_end_file)),
              IsEmpty());
}

}  // namespace
}  // namespace eerie::run
