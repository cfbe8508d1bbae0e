#include "solver/run/run.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include "solver/base/error.hpp"
#include "solver/base/files/folders.hpp"
#include "solver/run/beginning.hpp"
#include "solver/run/checkpoints.hpp"
#include "solver/step/late.hpp"
#include "solver/step/solver.hpp"

namespace eerie::run {
namespace fs = std::filesystem;

namespace {

constexpr const char* last_good_file = "last_good.hdf5";

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

bool is_whole(double number) { return std::abs(number - std::round(number)) < 1e-9; }

/// Outputs fall due by the number of whole intervals that have passed, a function of simulated
/// time alone, so an interrupted run writes the same ones.
class Schedule {
 public:
  Schedule(double interval, double now) : interval_(interval), done_(passed(now)) {}
  /// Goes on to `now`; whether an output fell due on the way.
  bool pass(double now) {
    const long before = done_;
    done_ = std::max(done_, passed(now));
    return done_ > before;
  }
  long count() const { return done_; }
  bool falls_on(double now) const { return interval_ > 0 && is_whole(now / interval_); }
  double next() const {
    return interval_ > 0 ? static_cast<double>(done_ + 1) * interval_
                         : std::numeric_limits<double>::infinity();
  }

 private:
  long passed(double now) const {
    return interval_ > 0 ? static_cast<long>(std::floor(now / interval_ * (1 + 1e-12))) : 0;
  }
  double interval_;
  long done_;
};

/// When a run ends whose remnants do not settle before. From end.time_s on it may end as soon as
/// nothing will meet, asked every thirtieth of that time, and at end.latest_s it does: a function
/// of simulated time alone, so that an interrupted run ends at the same moment.
class Ending {
 public:
  Ending(const Scene::End& end, const std::function<bool(const io::Snapshot&)>& will_meet)
      : end_(end), will_meet_(will_meet) {}

  /// The next moment at which a run that has come to `now` may end.
  double next(double now) const {
    if (end_.latest_s <= end_.time_s || now < end_.time_s * (1 - rounding)) return end_.time_s;
    const double asked = std::floor(intervals(now) + 1e-6);
    return std::min(end_.latest_s, end_.time_s + (asked + 1) * interval());
  }
  /// Whether a run may end at this moment, other than by settling.
  bool falls_on(double now) const {
    if (now < end_.time_s * (1 - rounding)) return false;
    return now >= std::max(end_.time_s, end_.latest_s) * (1 - rounding) || is_whole(intervals(now));
  }
  /// Why a run that may end now does; nothing where it goes on.
  template <class MakeSnapshot>
  std::optional<EndReason> reason(double now, MakeSnapshot&& snapshot) const {
    if (end_.latest_s <= end_.time_s) return EndReason::end_time;
    if (!will_meet_ || !will_meet_(snapshot())) return EndReason::end_time;
    if (now >= end_.latest_s * (1 - rounding)) return EndReason::latest_time;
    return std::nullopt;
  }
  static constexpr double rounding = 1e-12;

 private:
  double interval() const { return end_.time_s / 30; }  ///< between two questions, s
  double intervals(double now) const { return (now - end_.time_s) / interval(); }

  Scene::End end_;
  const std::function<bool(const io::Snapshot&)>& will_meet_;
};

class Run {
 public:
  Run(const Scene& scene, const RunOptions& options, Clock::time_point start, Beginning beginning)
      : scene_(scene),
        options_(options),
        first_totals_(beginning.first),
        start_(start),
        solver_(std::move(beginning.solver)),
        snapshots_(scene.output.snapshot_interval_s, solver_.state().time),
        histories_(scene.output.history_interval_s, solver_.state().time),
        looks_(scene.end.settled.window_s / looks_per_window, solver_.state().time),
        last_good_(checkpoint()),
        depends_on_end_(has_state_before_end()),
        ending_(scene.end, options.will_meet),
        goal_(ending_.next(solver_.state().time)),
        has_ended_(beginning.has_ended) {}

  RunSummary go() {
    const long first_step = solver_.state().step;
    RunEnd end = RunEnd::finished;
    over_ = has_ended_ ? old_reason_to_end() : reason_to_end();
    while (!over_) {
      if (options_.max_steps > 0 && solver_.state().step - first_step >= options_.max_steps) {
        end = RunEnd::step_limit;
        break;
      }
      if (options_.stop && options_.stop()) {
        end = RunEnd::stopped;
        break;
      }
      keep_before_cycle();
      advance();
      over_ = reason_to_end();
      write_outputs();
      if (options_.on_progress) options_.on_progress(progress());
    }
    {
      const StageTimer timer(solver_.stages(), Stage::output);
      if (end == RunEnd::finished)
        io::write_snapshot(options_.directory / final_file, lasting_checkpoint());
      else
        install_checkpoint(options_.directory, lasting_checkpoint());
    }
    RunSummary summary;
    summary.end = end;
    summary.reason = over_.value_or(EndReason::end_time);
    summary.last = snapshot();
    summary.first_totals = first_totals_;
    summary.last_totals = step::totals(scene_, solver_.state());
    summary.progress = progress();
    summary.stages = solver_.stages();
    summary.steps_here = static_cast<double>(solver_.state().step - first_step);
    summary.list_builds = earlier_list_builds_ + solver_.list_builds();
    summary.threads = options_.threads;
    return summary;
  }

 private:
  /// Asked at the start and after every cycle; looks at the remnants when a look is due and at the
  /// goals alone.
  std::optional<EndReason> reason_to_end() {
    if (is_at_goal()) keep_before_end();  // the last cycle was made to end here
    if (looks_.pass(solver_.state().time) && options_.look) {
      const bool may_soften = softest_sound_speed(scene_) < 1 && !solver_.state().softening.is_calm;
      const LookQuestion question{may_soften, next_stop()};
      auto [answer, end_matters] = looked(question);
      if (end_matters) keep_before_end();
      if (std::holds_alternative<End>(answer)) return EndReason::settled;
      if (auto* soften = std::get_if<Soften>(&answer)) go_on_softer(soften->to);
      if (auto* fly = std::get_if<Fly>(&answer)) land(std::move(fly->landing));
    }
    if (!is_at_goal()) return std::nullopt;
    keep_before_end();  // maybe a flight was made to end here
    const double now = solver_.state().time;
    const auto reason = ending_.reason(now, [this] { return snapshot(); });
    if (!reason) goal_ = ending_.next(now);
    return reason;
  }

  struct Looked {
    LookAnswer answer;
    bool end_matters;  ///< and nothing was kept yet of the state before
  };
  Looked looked(const LookQuestion& question) {
    const StageTimer timer(solver_.stages(), Stage::looks);
    const io::Snapshot seen = snapshot();
    LookAnswer answer = options_.look(seen, question);
    return {std::move(answer),
            !depends_on_end_ && options_.end_matters && options_.end_matters(seen, question)};
  }

  /// Of a run that had ended, and was killed before its result was noted.
  std::optional<EndReason> old_reason_to_end() {
    const double now = solver_.state().time;
    if (!ending_.falls_on(now)) return EndReason::settled;
    if (looks_.falls_on(now) && options_.look &&
        std::holds_alternative<End>(options_.look(snapshot(), {false, now})))
      return EndReason::settled;
    return ending_.reason(now, [this] { return snapshot(); });
  }

  bool is_at_goal() const { return solver_.state().time >= goal_ * (1 - Ending::rounding); }

  /// Goes on with another state; the new solver keeps the old one's accounts.
  void go_on_with(particles::State state) {
    const StageTimes spent = solver_.stages();
    earlier_list_builds_ += solver_.list_builds();
    solver_ = step::Solver(scene_, std::move(state));
    cycles_ = 0;
    for (std::size_t k = 0; k < stage_count; ++k) solver_.stages().seconds[k] += spent.seconds[k];
  }

  /// A flight must not pass over a snapshot, or the moment at which the run may end.
  double next_stop() const { return std::min(goal_, snapshots_.next()); }

  void land(particles::Landing landing) {
    particles::State& state = landing.state;
    if (landing.for_impact && state.softening.sound_speed < 1)
      state = step::with_softening(std::move(state), solver_.pressure(), scene_, {});
    go_on_with(std::move(state));
    looks_.pass(solver_.state().time);  // the next one after a whole interval, as after a restart
    note(fmt::format("t = {:.0f} s: {}", solver_.state().time, landing.how));
  }

  void go_on_softer(const particles::Softening& to) {
    go_on_with(step::with_softening(solver_.state(), solver_.pressure(), scene_, to));
    note(fmt::format("t = {:.0f} s: {}; sound speeds are {:g} times those of the scene",
                     solver_.state().time, to.is_calm ? "remnants are calm" : "matter moves slowly",
                     to.sound_speed));
  }

  void note(const std::string& text) const {
    if (options_.on_note) options_.on_note(text);
  }

  bool has_state_before_end() const {
    const auto to_log = [this](const std::string& text) { note(text); };
    return usable_checkpoint(options_.directory / before_end_file, scene_, to_log).has_value();
  }

  /// Copies the state where the run may depend on its end after the next cycle: where a look or a
  /// goal is near, or where nothing is known yet of how long cycles are.
  void keep_before_cycle() {
    constexpr double cycles_ahead = 8;
    constexpr long settled_in = 2;
    const double now = solver_.state().time, near = cycles_ahead * (now - before_cycle_time_);
    const bool is_near = std::min(goal_, looks_.next()) - now <= near;
    before_cycle_time_ = now;
    if (!depends_on_end_ && (is_near || cycles_ < settled_in))
      before_cycle_ = checkpoint();
    else
      before_cycle_.reset();
    ++cycles_;
  }

  /// The state before the first cycle that a run with a later end would not have made, or after
  /// which it would have gone on otherwise, is installed.
  void keep_before_end() {
    if (depends_on_end_) return;
    depends_on_end_ = true;
    if (before_cycle_) io::write_snapshot(options_.directory / before_end_file, *before_cycle_);
    before_cycle_.reset();
  }

  /// A cycle. Where it fails, the state of the last history row, which was sound, is installed.
  void advance() {
    try {
      solver_.cycle(goal_);
    } catch (const NumericalError& error) {
      const fs::path path = options_.directory / last_good_file;
      io::write_snapshot(path, last_good_);
      throw NumericalError(error.kind, error.step, error.particle_id,
                           fmt::format("{}; the last good checkpoint, of t = {:.6g} s, is {}",
                                       error.what(), last_good_.state.time, path.string()));
    }
  }

  void write_outputs() {
    const StageTimer timer(solver_.stages(), Stage::output);
    const double time = solver_.state().time;
    if (snapshots_.pass(time) && !over_)
      io::write_snapshot(snapshot_path(options_.directory, snapshots_.count()), snapshot());
    if (histories_.pass(time)) {
      last_good_ = checkpoint();
      if (options_.on_history) options_.on_history(snapshot(), first_totals_);
    }
    if (seconds_since(last_checkpoint_) >= scene_.output.checkpoint_interval_s) {
      install_checkpoint(options_.directory, lasting_checkpoint());
      last_checkpoint_ = Clock::now();
    }
  }

  /// One whose caller has flushed what belongs to it.
  io::Snapshot lasting_checkpoint() const {
    if (options_.before_checkpoint) options_.before_checkpoint();
    return checkpoint();
  }

  io::Snapshot snapshot() const { return {scene_, solver_.state(), solver_.pressure(), {}, {}}; }
  io::Snapshot checkpoint() const {
    return {scene_, solver_.state(), solver_.pressure(), solver_.rates(), solver_.restart()};
  }
  Progress progress() const {
    const particles::State& s = solver_.state();
    return {s.time,
            goal_,
            s.step,
            solver_.dt(),
            static_cast<double>(s.step) * static_cast<double>(s.size()),
            seconds_since(start_)};
  }

  const Scene& scene_;
  const RunOptions& options_;
  step::Totals first_totals_;
  Clock::time_point start_;  ///< before bodies were made
  Clock::time_point last_checkpoint_ = Clock::now();
  step::Solver solver_;
  Schedule snapshots_, histories_, looks_;
  io::Snapshot last_good_;  ///< a checkpoint of the last history row
  bool depends_on_end_;     ///< whether a run with a later end would have done otherwise
  std::optional<io::Snapshot> before_cycle_ = {};  ///< a checkpoint before the last cycle
  double before_cycle_time_ = 0;                   ///< time before the last cycle, s
  long cycles_ = 0;  ///< since the start, or since matter got other moduli or landed
  Ending ending_;
  double goal_;                   ///< the run may end then, and is asked again
  bool has_ended_;                ///< in an earlier attempt
  long earlier_list_builds_ = 0;  ///< of solvers before this one
  std::optional<EndReason> over_;
};

/// Of a run that did not begin.
RunSummary summary_of(NotBegun stopped, const Scene& scene, const RunOptions& options) {
  RunSummary summary;
  summary.end = stopped.end;
  summary.first_totals = summary.last_totals = step::totals(scene, stopped.last.state);
  const particles::State& s = stopped.last.state;
  summary.progress.time = s.time, summary.progress.end_time = scene.end.time_s;
  summary.progress.step = s.step;
  summary.progress.particle_steps = static_cast<double>(s.step) * static_cast<double>(s.size());
  summary.threads = options.threads;
  summary.last = std::move(stopped.last);
  if (options.on_note && s.step == 0)
    options.on_note(
        fmt::format("stopped after {} steps of the bodies on their way to rest", stopped.steps));
  return summary;
}

}  // namespace

RunSummary run_impact(const Scene& scene, const RunOptions& options) {
  omp_set_num_threads(options.threads);
  make_folders(options.directory);
  const Clock::time_point start = Clock::now();
  auto beginning = begin(scene, options);
  if (auto* stopped = std::get_if<NotBegun>(&beginning))
    return summary_of(std::move(*stopped), scene, options);
  return Run(scene, options, start, std::get<Beginning>(std::move(beginning))).go();
}

}  // namespace eerie::run
