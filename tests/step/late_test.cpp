#include "solver/step/late.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/step/solver.hpp"
#include "tests/run/runs.hpp"

namespace eerie::step {
namespace {

using nlohmann::json;
using particles::Softening;
using test::differences;
using test::run_in;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

/// short_impact() with a late phase, looked for every 5 s.
Scene late_impact(const json& more = json::object()) {
  json fields = {{"numerics", {{"late_sound_speed", 0.25}}},
                 {"end", {{"time_s", 60}, {"settled", {{"window_s", 40}}}}}};
  fields.merge_patch(more);
  return test::short_impact(fields);
}

run::RunOptions calm_from(double time) {
  run::RunOptions options;
  options.look = [time](const io::Snapshot& s,
                        const run::LookQuestion& question) -> run::LookAnswer {
    if (question.may_soften && s.state.time > time) return run::Soften{{0.25, true}};
    return run::GoOn{};
  };
  return options;
}

TEST(LatePhase, HasSoundSpeedsTimesTheFactor) {
  const Scene scene = late_impact();
  const Scene soft = softened(scene, {0.25, true});
  EXPECT_DOUBLE_EQ(bulk_sound_speed(soft), bulk_sound_speed(scene) / 4);
  EXPECT_DOUBLE_EQ(soft.material.shear_modulus_Pa, scene.material.shear_modulus_Pa / 16);
  EXPECT_EQ(scene_hash(softened(scene, {})), scene_hash(scene));
}

TEST(LatePhase, BeginsWithThePressuresThatWereThere) {
  const Scene scene = late_impact();
  const TemporaryFolder folder;
  const io::Snapshot before = run_in(folder, scene).summary.last;
  ASSERT_EQ(before.state.softening, Softening{});
  const Solver after(scene, with_softening(before.state, before.pressure, scene, {0.25, true}));
  EXPECT_EQ(after.state().softening, (Softening{0.25, true}));
  std::vector<double> was(before.state.size());
  for (std::size_t i = 0; i < was.size(); ++i) was[before.state.id[i]] = before.pressure[i];
  int pressed = 0;
  for (std::size_t i = 0; i < was.size(); ++i) {
    const double expected = was[after.state().id[i]];
    EXPECT_NEAR(after.pressure()[i], expected, 1e-9 * std::abs(expected) + 1e-12);
    pressed += expected > 0;
  }
  EXPECT_GT(pressed, 50);
}

TEST(LatePhase, TakesLongerStepsAndIsKeptInTheState) {
  const Scene scene = late_impact();
  const TemporaryFolder folder, other;
  const run::RunSummary late = run_in(folder, scene, calm_from(30)).summary;
  const run::RunSummary never = run_in(other, scene, calm_from(1e9)).summary;
  EXPECT_EQ(late.last.state.softening, (Softening{0.25, true}));
  EXPECT_EQ(never.last.state.softening, Softening{});
  EXPECT_EQ(io::read_snapshot(folder / "final.hdf5").state.softening, (Softening{0.25, true}));
  // Half of the time with steps that may be four times as long.
  EXPECT_LT(late.progress.step, 0.75 * static_cast<double>(never.progress.step));
}

TEST(LatePhase, ChangesNothingBeforeItBegins) {
  const TemporaryFolder folder, other;
  const io::Snapshot late = run_in(folder, late_impact(), calm_from(1e9)).summary.last;
  const io::Snapshot never =
      run_in(other, late_impact({{"numerics", {{"late_sound_speed", 1}}}}), calm_from(0))
          .summary.last;
  EXPECT_THAT(differences(late, never), testing::ElementsAre("scene"));  // but for what it allows
}

TEST(LatePhase, HoldsViscosityWhileMatterStillFlows) {
  const Scene scene = late_impact();
  const double alpha = scene.numerics.viscosity_alpha, c = bulk_sound_speed(scene);
  const Scene slow = softened(scene, {0.25, false}), calm = softened(scene, {0.25, true});
  EXPECT_DOUBLE_EQ(slow.numerics.viscosity_alpha * bulk_sound_speed(slow), alpha * c);
  EXPECT_EQ(slow.numerics.viscosity_beta, scene.numerics.viscosity_beta);  // beta has no c
  EXPECT_EQ(calm.numerics.viscosity_alpha, alpha);
}

/// Matter moves slowly from 10 s on, more so from 20 s on, and is calm from 30 s on.
run::RunOptions slower_and_slower() {
  run::RunOptions options;
  options.look = [](const io::Snapshot& s, const run::LookQuestion& question) -> run::LookAnswer {
    if (!question.may_soften) return run::GoOn{};
    const double t = s.state.time;
    return run::Soften{t > 30   ? Softening{0.25, true}
                       : t > 20 ? Softening{0.25, false}
                       : t > 10 ? Softening{0.5, false}
                                : Softening{}};
  };
  return options;
}

void has_the_same_bits_always(const Scene& scene) {
  const TemporaryFolder whole, pieces, threads;
  run::RunOptions options = slower_and_slower();
  run_in(whole, scene, options);
  const io::Snapshot expected = io::read_snapshot(whole / "final.hdf5");
  options.threads = 3;
  run_in(threads, scene, options);
  EXPECT_THAT(differences(io::read_snapshot(threads / "final.hdf5"), expected), IsEmpty());
  options.threads = 1, options.max_steps = 11;
  while (run_in(pieces, scene, options).summary.end == run::RunEnd::step_limit) continue;
  EXPECT_THAT(differences(io::read_snapshot(pieces / "final.hdf5"), expected), IsEmpty());
}

TEST(LatePhase, HasTheSameBitsForAnyNumberOfThreadsAndOfInterruptions) {
  has_the_same_bits_always(late_impact());
}

TEST(LatePhase, HasTheSameBitsAlwaysWhereViscosityDampsInStages) {
  const auto thick = [](int stages) {
    return late_impact(
        {{"numerics",
          {{"viscous_stages", stages}, {"viscosity_particles", 0}, {"viscosity_alpha", 2}}}});
  };
  has_the_same_bits_always(thick(3));
  const TemporaryFolder one, three;  // several stages are at work: there are fewer steps
  EXPECT_LT(run_in(three, thick(3), slower_and_slower()).summary.last.state.step,
            run_in(one, thick(1), slower_and_slower()).summary.last.state.step);
}

TEST(LatePhase, IsRefusedWhereNothingLooksOrAnEnergyBudgetIsKept) {
  EXPECT_THAT(
      [] {
        parse_scene({{"numerics", {{"late_sound_speed", 0.5}}}});
      },
      ThrowsMessage<InputError>(HasSubstr("end.settled.window_s")));
  EXPECT_THAT(
      [] {
        late_impact({{"material", {{"energy", "integrated"}}}});
      },
      ThrowsMessage<InputError>(HasSubstr("energy budget")));
}

}  // namespace
}  // namespace eerie::step
