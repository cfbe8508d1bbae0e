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

/// How far a run is; handed out after every cycle (a few steps).
struct Progress {
  double time = 0, end_time = 0;  ///< simulated, s
  long step = 0;
  double dt = 0;              ///< s
  double particle_steps = 0;  ///< since the start of the run, interruptions included
  double wall_s = 0;          ///< of this process
};

enum class RunEnd { finished, stopped, step_limit };

/// Why a finished run ended: its remnants had settled, its time was over (and, where it may wait,
/// nothing was going to meet), or it had waited for as long as it may.
enum class EndReason { settled, end_time, latest_time };
inline constexpr std::array<std::string_view, 3> end_reason_names = {"settled", "end-time",
                                                                     "latest-time"};

struct RunSummary {
  RunEnd end = RunEnd::finished;
  EndReason reason = EndReason::end_time;  ///< of a finished run
  io::Snapshot last;                       ///< state at the end, pressures included
  step::Totals first_totals, last_totals;  ///< at time 0 and at the end
  Progress progress;
  StageTimes stages;      ///< of this process
  double steps_here = 0;  ///< steps done by this process
  long list_builds = 0;   ///< of this process
  int threads = 1;
};

struct LookQuestion {
  bool may_soften;  ///< whether sound speeds may fall further (numerics.late_sound_speed)
  double until;     ///< s: a flight may last no longer
};

// What a look at the remnants answers.

/// Matter goes on moving.
struct GoOn {};
/// Matter moves slowly: it is softer from now on.
struct Soften {
  particles::Softening to;
};
/// Nothing changes but places until a later time: the run goes on from there.
struct Fly {
  particles::Landing landing;
};
/// Nothing changes any more.
struct End {};
using LookAnswer = std::variant<GoOn, Soften, Fly, End>;

/// What the caller wants of a run besides its end.
struct RunOptions {
  std::filesystem::path directory;  ///< checkpoint, snapshots and final state are installed here
  int threads = 1;
  long max_steps = 0;  ///< of this process, rounded up to whole cycles; 0: until the end time
  /// Of bodies on their way to rest, of this process; 0: as many as they need.
  long max_settling_steps = 0;
  std::function<void(const Progress&)> on_progress;  ///< after every cycle of steps; must be cheap
  /// Every output.history_interval_s, with the totals at time 0.
  std::function<void(const io::Snapshot&, const step::Totals& first)> on_history;
  /// Asked `looks_per_window` times in end.settled.window_s, from the start on.
  std::function<LookAnswer(const io::Snapshot&, const LookQuestion&)> look;
  /// Whether remnants will meet; asked from end.time_s on where end.latest_s is later.
  std::function<bool(const io::Snapshot&)> will_meet;
  /// Asked after every cycle, those of settling bodies included; true: checkpoint and return.
  std::function<bool()> stop;
  std::function<void(const std::string&)> on_note;  ///< a sentence for the log
};

/// Makes the bodies of `scene` and lets them collide, or goes on from the newest checkpoint in
/// `directory` that holds the same scene and solver version (run/checkpoints.hpp). One that is
/// stopped while its bodies come to rest is at time 0 and step 0, and goes on with them too.
/// snapshot_0000.hdf5 is the state at time 0; final.hdf5 the last one, itself a checkpoint. The
/// same scene gives the same bits for any number of threads and of interruptions. Throws
/// NumericalError, after last_good.hdf5 has been written: a checkpoint of the last history row
/// before the failure; copied over checkpoint.hdf5 it is gone on from. Throws EnvironmentError.
RunSummary run_impact(const Scene& scene, const RunOptions& options);

}  // namespace eerie::run
