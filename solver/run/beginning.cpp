#include "solver/run/beginning.hpp"

#include <fmt/format.h>

#include "solver/initial/bodies.hpp"
#include "solver/initial/packing.hpp"
#include "solver/initial/remnant_body.hpp"
#include "solver/run/checkpoints.hpp"
#include "solver/run/kept_bodies.hpp"
#include "solver/scene/tide.hpp"

namespace eerie::run {
namespace fs = std::filesystem;

namespace {

using particles::Body;

constexpr std::array<const char*, 2> settling_files = {"settling_target.hdf5",
                                                       "settling_impactor.hdf5"};

class Begin {
 public:
  Begin(const Scene& scene, const RunOptions& options)
      : scene_(scene), options_(options), kept_(options.bodies, to_log()) {}

  std::variant<Beginning, NotBegun> operator()() {
    if (auto saved = newest_checkpoint(options_.directory, scene_, to_log())) {
      const std::optional<step::Totals> first = initial_totals();
      io::Snapshot& from = saved->state;
      if (!first) return NotBegun{*end_, std::move(from), steps_};
      note(fmt::format("going on from t = {:.0f} s, step {}", from.state.time, from.state.step));
      return Beginning{solver_from(std::move(from), scene_), *first, saved->is_final};
    }
    io::Snapshot start{scene_, made_impact(), {}, {}, {}};
    if (end_) return NotBegun{*end_, std::move(start), steps_};
    step::Solver solver(scene_, std::move(start.state));
    const step::Totals first = step::totals(scene_, solver.state());
    io::write_snapshot(snapshot_path(options_.directory, 0),
                       {scene_, solver.state(), solver.pressure(), {}, {}});
    for (const char* name : settling_files) fs::remove(options_.directory / name);
    return Beginning{std::move(solver), first};
  }

 private:
  std::function<void(const std::string&)> to_log() const {
    return [this](const std::string& text) { note(text); };
  }

  /// Of time 0, from the first snapshot or, where that is lost, from making the bodies again.
  /// Nothing where that was stopped.
  std::optional<step::Totals> initial_totals() {
    try {
      return step::totals(scene_, io::read_snapshot(snapshot_path(options_.directory, 0)).state);
    } catch (const std::exception& error) {
      note(fmt::format("{}; making the initial bodies again", error.what()));
    }
    particles::State made = made_impact();
    if (end_) return std::nullopt;
    return step::totals(scene_, step::Solver(scene_, std::move(made)).state());
  }

  /// Both bodies at rest, on their orbit; where it was stopped, `end_` is set and they are not at
  /// rest.
  particles::State made_impact() {
    initial::require_orbit(scene_);
    const std::optional<initial::Settling> target = settled(Body::target);
    if (end_) return stopped(target, {});
    const std::optional<initial::Settling> impactor = settled(Body::impactor);
    if (end_) return stopped(target, impactor);
    return initial::on_their_orbit(scene_, target->body(), impactor->body());
  }

  /// Something to show of a run that did not begin, made at once.
  particles::State stopped(const std::optional<initial::Settling>& target,
                           const std::optional<initial::Settling>& impactor) const {
    if (target) keep(Body::target, *target);
    if (impactor) keep(Body::impactor, *impactor);
    Scene quick = scene_;
    quick.numerics.packing = "lattice";
    return initial::make_unsettled_impact(quick);
  }

  /// Nothing where it was stopped before there was anything to keep.
  std::optional<initial::Settling> settled(Body body) {
    std::optional<initial::Settling> settling;
    // A remnant is a file already.
    const bool is_shared = kept_.keeps() && !initial::is_remnant(scene_, body);
    if (auto kept = is_shared ? kept_.find(scene_, body) : std::nullopt) {
      settling.emplace(scene_, body, solver_from(*std::move(kept), without_primary(scene_)));
      return settling;
    }
    try {
      settling.emplace(begun(body));
    } catch (const initial::PackingStopped&) {
      return settling;
    }
    while (!settling->is_at_rest() && !is_over()) {
      const long before = settling->solver().state().step;
      settling->cycle();
      steps_ += settling->solver().state().step - before;
    }
    if (!end_ && is_shared) {
      keep(body, *settling);
      kept_.keep(scene_, body, file_of(body));
    }
    return settling;
  }

  /// Of a checkpoint.
  static step::Solver solver_from(io::Snapshot saved, const Scene& scene) {
    return {scene, std::move(saved.state), std::move(*saved.rates), *saved.restart,
            std::move(saved.pressure)};
  }

  fs::path file_of(Body body) const {
    return options_.directory / settling_files.at(static_cast<std::size_t>(body));
  }

  void keep(Body body, const initial::Settling& settling) const {
    const step::Solver& s = settling.solver();
    if (s.state().step == 0) return;
    io::write_snapshot(file_of(body), {scene_, s.state(), s.pressure(), s.rates(), s.restart()});
  }

  initial::Settling begun(Body body) {
    const fs::path file = file_of(body);
    auto saved = usable_checkpoint(file, scene_, to_log());
    if (!saved) return {scene_, body, [this] { return is_over(); }};
    note(fmt::format("{}: going on from step {} of its way to rest", file.string(),
                     saved->state.step));
    return {scene_, body, solver_from(*std::move(saved), without_primary(scene_))};
  }

  bool is_over() {
    if (end_) return true;
    if (options_.max_settling_steps > 0 && steps_ >= options_.max_settling_steps)
      end_ = RunEnd::step_limit;
    else if (options_.stop && options_.stop())
      end_ = RunEnd::stopped;
    return end_.has_value();
  }

  void note(const std::string& text) const {
    if (options_.on_note) options_.on_note(text);
  }

  const Scene& scene_;
  const RunOptions& options_;
  KeptBodies kept_;
  long steps_ = 0;
  std::optional<RunEnd> end_;  ///< set once the run is not to begin
};

}  // namespace

std::variant<Beginning, NotBegun> begin(const Scene& scene, const RunOptions& options) {
  return Begin(scene, options)();
}

}  // namespace eerie::run
