#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "solver/base/stages.hpp"
#include "solver/io/snapshot.hpp"
#include "solver/particles/landing.hpp"
#include "solver/scene/scene.hpp"
#include "solver/step/totals.hpp"

namespace eerie::run {

/// The progress of a run, reported after every cycle (a few steps).
struct Progress {
  double time = 0, end_time = 0;  ///< simulated time, s
  long step = 0;
  double dt = 0;              ///< s
  double particle_steps = 0;  ///< since the start of the run, over all its processes
  double wall_s = 0;          ///< of this process
};

enum class RunEnd { finished, stopped, step_limit };

/// Why a finished run ended. `settled`: its remnants had settled. `end_time`: its time was over,
/// and no remnants were going to meet. `latest_time`: remnants were going to meet, but the run may
/// wait no longer.
enum class EndReason { settled, end_time, latest_time };
inline constexpr std::array<std::string_view, 3> end_reason_names = {"settled", "end-time",
                                                                     "latest-time"};

struct RunSummary {
  RunEnd end = RunEnd::finished;
  EndReason reason = EndReason::end_time;  ///< of a finished run
  io::Snapshot last;                       ///< state at the end, with pressures
  step::Totals first_totals, last_totals;  ///< at time 0 and at the end
  Progress progress;
  StageTimes stages;      ///< of this process
  double steps_here = 0;  ///< steps done by this process
  long list_builds = 0;   ///< of this process
  int threads = 1;

  /// Of the stepping in this process alone: bodies are made once, however long the run.
  double particle_steps_per_core_second() const {
    const double core_seconds = stages.total() * threads;
    return core_seconds > 0 ? steps_here * static_cast<double>(last.state.size()) / core_seconds
                            : 0;
  }
};

struct LookQuestion {
  bool may_soften;  ///< whether sound speeds may fall further (numerics.late_sound_speed)
  double until;     ///< the latest time at which a flight may end, s
};

// These are the answers of a look at the remnants.

/// Go on: matter still moves.
struct GoOn {};
/// Soften: matter moves slowly, and has this softening from now on.
struct Soften {
  particles::Softening to;
};
/// Fly: only positions change until a later time, from which the run continues.
struct Fly {
  particles::Landing landing;
};
/// End: nothing changes any more.
struct End {};
using LookAnswer = std::variant<GoOn, Soften, Fly, End>;

/// What the caller wants from a run besides its final state.
struct RunOptions {
  std::filesystem::path directory;  ///< folder for checkpoints, snapshots and the final state
  std::filesystem::path bodies;     ///< folder of bodies shared with other runs; empty: none
  int threads = 1;
  long max_steps = 0;  ///< most steps of this process, rounded up to whole cycles; 0: no limit
  /// The most steps of settling bodies in this process; 0: as many as they need.
  long max_settling_steps = 0;
  std::function<void(const Progress&)> on_progress;  ///< after every cycle of steps; must be cheap
  /// Called every output.history_interval_s, with the totals at time 0.
  std::function<void(const io::Snapshot&, const step::Totals& first)> on_history;
  /// Called before a checkpoint or the final state is installed: what was written of the time until
  /// then must last as the state does.
  std::function<void()> before_checkpoint;
  /// Called `looks_per_window` times per end.settled.window_s, from the start on.
  std::function<LookAnswer(const io::Snapshot&, const LookQuestion&)> look;
  /// Whether remnants will meet. Called from end.time_s on, where end.latest_s is later.
  std::function<bool(const io::Snapshot&)> will_meet;
  /// Whether the answer of look() is another one where the run may go on for longer. Called after
  /// look(), with what that was asked, until it is true.
  std::function<bool(const io::Snapshot&, const LookQuestion&)> end_matters;
  /// Called after every cycle, also of settling bodies. Where it is true the run writes a
  /// checkpoint and returns.
  std::function<bool()> stop;
  std::function<void(const std::string&)> on_note;  ///< called with a sentence for the log
};

/// Makes the bodies of `scene` and lets them collide, or continues from the newest checkpoint in
/// `directory` of the same scene and solver version (run/checkpoints.hpp). A run that is stopped
/// while its bodies come to rest is at time 0 and step 0; it continues too. snapshot_0000.hdf5 is
/// the state at time 0. final.hdf5 is the last state and also a checkpoint. The same scene gives
/// the same bits for any number of threads and of interruptions. before_end.hdf5 is a checkpoint of
/// the last cycle that a run with a later end would have made as well. Throws NumericalError after
/// it has written last_good.hdf5, a checkpoint of the last history row before the failure. A run
/// continues from that once it is copied over checkpoint.hdf5. Throws EnvironmentError.
RunSummary run_impact(const Scene& scene, const RunOptions& options);

}  // namespace eerie::run
