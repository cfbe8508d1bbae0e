#include <gmock/gmock.h>
#include <signal.h>

#include <fstream>

#include "solver/base/file.hpp"
#include "solver/base/kill_point.hpp"
#include "solver/run/checkpoints.hpp"
#include "tests/run/runs.hpp"

namespace eerie::run {
namespace {
namespace fs = std::filesystem;

using test::differences;
using test::run_in;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scene scene() { return test::short_impact({{"end", {{"time_s", 120}}}}); }

/// The end of a run that nothing befell.
const io::Snapshot& undisturbed() {
  static const io::Snapshot end = [] {
    const TemporaryFolder folder;
    run_in(folder, scene());
    return io::read_snapshot(folder / final_file);
  }();
  return end;
}

/// Runs until two checkpoints are there, of different steps.
void begin_run(const TemporaryFolder& folder) {
  RunOptions options;
  options.max_steps = 20;
  for (int part = 0; part < 2; ++part) run_in(folder, scene(), options);
  ASSERT_LT(io::read_snapshot(folder / previous_checkpoint_file).state.step,
            io::read_snapshot(folder / checkpoint_file).state.step);
}

void spoil(const fs::path& path, const std::string& how) {
  const std::string bytes = read_file(path);
  std::string spoilt = bytes;
  if (how == "truncated") spoilt = bytes.substr(0, bytes.size() * 2 / 3);
  if (how == "without its last byte") spoilt.pop_back();
  if (how == "empty") spoilt.clear();
  if (how == "a bit flipped") spoilt[bytes.size() / 2] ^= 0x10;
  if (how == "a zeroed page") std::fill_n(spoilt.begin() + 8192, 4096, '\0');
  if (how == "of another solver") {
    io::Snapshot other = io::read_snapshot(path);
    other.solver_version = "0.0.9";
    return io::write_snapshot(path, other);
  }
  if (how == "gone") return void(fs::remove(path));
  ASSERT_NE(spoilt, bytes);
  std::ofstream(path, std::ios::binary | std::ios::trunc) << spoilt;
}

class SpoiltCheckpoint : public testing::TestWithParam<const char*> {};

TEST_P(SpoiltCheckpoint, GivesWayToThePreviousOneAndTheRunEndsWithTheSameBits) {
  const TemporaryFolder folder;
  begin_run(folder);
  const long previous = io::read_snapshot(folder / previous_checkpoint_file).state.step;
  spoil(folder / checkpoint_file, GetParam());
  const auto told = run_in(folder, scene());
  EXPECT_EQ(told.summary.progress.step - static_cast<long>(told.summary.steps_here), previous);
  EXPECT_THAT(differences(io::read_snapshot(folder / final_file), undisturbed()), IsEmpty());
  if (GetParam() == std::string("gone")) return;
  EXPECT_THAT(told.notes,
              ElementsAre(testing::AllOf(HasSubstr("checkpoint.hdf5"), HasSubstr("passed over")),
                          HasSubstr("going on from")));
}

TEST_P(SpoiltCheckpoint, DoesNotPushOutThePreviousOne) {
  const TemporaryFolder folder;
  begin_run(folder);
  spoil(folder / checkpoint_file, GetParam());
  RunOptions options;
  options.max_steps = 1;
  run_in(folder, scene(), options);
  EXPECT_LT(io::read_snapshot(folder / previous_checkpoint_file).state.step,
            io::read_snapshot(folder / checkpoint_file).state.step);
}

TEST_P(SpoiltCheckpoint, ThatIsTheOnlyOneMeansToStartAgain) {
  const TemporaryFolder folder;
  begin_run(folder);
  spoil(folder / checkpoint_file, GetParam());
  spoil(folder / previous_checkpoint_file, GetParam());
  const auto told = run_in(folder, scene());
  EXPECT_EQ(told.summary.steps_here, static_cast<double>(told.summary.progress.step));
  EXPECT_THAT(differences(io::read_snapshot(folder / final_file), undisturbed()), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Checkpoints, SpoiltCheckpoint,
                         testing::Values("truncated", "without its last byte", "empty",
                                         "a bit flipped", "a zeroed page", "of another solver",
                                         "gone"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::erase(name, ' ');
                           return name;
                         });

TEST(Checkpoints, OfAnotherSolverVersionArePassedOverWithANote) {
  const TemporaryFolder folder;
  begin_run(folder);
  spoil(folder / checkpoint_file, "of another solver");
  std::vector<std::string> notes;
  newest_checkpoint(folder.path(), scene(),
                    [&](const std::string& note) { notes.push_back(note); });
  EXPECT_THAT(notes, ElementsAre(HasSubstr("is of solver version 0.0.9, this is " +
                                           std::string(solver_version))));
}

/// A run with a checkpoint after every cycle that is killed while it installs the third one.
[[noreturn]] void run_armed(const TemporaryFolder& folder, const std::string& where) {
  arm_kill_point(where);
  run_in(folder, test::short_impact(
                     {{"end", {{"time_s", 120}}}, {"output", {{"checkpoint_interval_s", 0}}}}));
  std::_Exit(0);
}

TEST(Checkpoints, KilledAnywhereInTheirInstallationLeaveOneFromWhichTheRunEndsWithTheSameBits) {
  for (const std::string_view name : kill_point_names) {
    if (!name.starts_with("install.") && !name.starts_with("checkpoint.")) continue;
    for (const char* passing : {":1", ":2", ":3"}) {
      const std::string where = std::string(name) + "@checkpoint.hdf5" + passing;
      const TemporaryFolder folder;
      EXPECT_EXIT(run_armed(folder, where), testing::KilledBySignal(SIGKILL), "") << where;
      int whole = 0;
      for (const char* file : {checkpoint_file, previous_checkpoint_file})
        if (fs::exists(folder / file)) io::read_snapshot(folder / file), ++whole;
      EXPECT_GE(whole, passing == std::string(":1") ? 0 : 1) << where;
      run_in(folder, scene());
      EXPECT_THAT(differences(io::read_snapshot(folder / final_file), undisturbed()), IsEmpty())
          << where;
    }
  }
}

}  // namespace
}  // namespace eerie::run
