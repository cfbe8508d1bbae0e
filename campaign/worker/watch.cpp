#include "campaign/worker/watch.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "analysis/ending/may_fly.hpp"
#include "analysis/remnants/meetings.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "solver/scene/tide.hpp"
#include "solver/step/deformation.hpp"
#include "solver/step/diagnosis.hpp"

namespace eerie::worker {

namespace {

/// Everything that a row of the history says of a state and its remnants.
job_folder::HistoryRow full_row(const io::Snapshot& snapshot, const remnants::Remnants& found,
                                const step::Totals& start) {
  job_folder::HistoryRow row = job_folder::history_row(snapshot.state.time, found.remnants);
  const step::Totals t = step::totals(snapshot.scene, snapshot.state);
  row.kinetic_energy_J = t.kinetic_energy, row.potential_energy_J = t.potential_energy;
  row.internal_energy_J = t.internal_energy, row.viscous_heat_J = t.viscous_heat;
  row.friction_heat_J = t.friction_heat, row.shear_energy_J = t.shear_energy;
  row.dL_over_L = job_folder::angular_momentum_drift(snapshot.scene, start, t).value_or(0);
  const step::Diagnosis d = step::diagnose(snapshot);
  row.eos_pressure_Pa = d.eos_pressure, row.viscous_pressure_Pa = d.viscous_pressure;
  row.pressureless = d.pressureless, row.density_kg_per_m3 = d.density;
  row.summed_density_kg_per_m3 = d.summed_density, row.density_error = d.density_error;
  return row;
}

/// The least of 1, 1/2, 1/4... that is no smaller than `factor`; 1 for what is larger.
double power_of_half_from(double factor) {
  double power = 1;
  while (power / 2 >= factor) power /= 2;
  return power;
}

}  // namespace

Watch::Watch(const Scene& scene, const job_folder::JobDirectory& folder)
    : scene_(scene),
      folder_(folder),
      stop_(folder.stop()),
      history_(folder.history()),
      looks_(folder.remnants()) {}

run::RunOptions Watch::options(int threads, long max_steps,
                               std::function<void(const run::Progress&)> on_progress) {
  run::RunOptions options;
  options.directory = folder_.path;
  options.threads = threads;
  options.max_steps = options.max_settling_steps = max_steps;
  options.on_progress = std::move(on_progress);
  options.on_history = [this](const io::Snapshot& snapshot, const step::Totals& start) {
    history_.add({full_row(snapshot, found_in(snapshot.state), start)});
  };
  options.before_checkpoint = [this] { history_.flush(), looks_.flush(); };
  options.look = [this](const io::Snapshot& snapshot, const run::LookQuestion& question) {
    return look(snapshot, question);
  };
  options.end_matters = [this](const io::Snapshot& snapshot, const run::LookQuestion& question) {
    return end_matters(snapshot, question);
  };
  options.will_meet = [this](const io::Snapshot& snapshot) {
    return !has_primary(scene_) &&
           remnants::will_meet(remnants::find_remnants(snapshot.state).remnants,
                               scene_.end.settled.fall_back);
  };
  options.stop = [this] { return stop_(); };
  options.on_note = [](const std::string& note) { spdlog::info("{}", note); };
  return options;
}

/// Looks and rows of the history often fall on one moment.
const remnants::Remnants& Watch::found_in(const particles::State& state) {
  if (state.time != found_at_) {
    found_ = remnants::find_remnants(state);
    found_at_ = state.time;
  }
  return found_;
}

/// A look asks up to three times, with other times ahead.
double Watch::flow_speed_in(const io::Snapshot& snapshot) {
  if (snapshot.state.time != flow_speed_at_) {
    flow_speed_ = step::flow_speed(snapshot);
    flow_speed_at_ = snapshot.state.time;
  }
  return flow_speed_;
}

run::LookAnswer Watch::look(const io::Snapshot& snapshot, const run::LookQuestion& question) {
  const remnants::Remnants& found = found_in(snapshot.state);
  looks_.add(ending::look(snapshot.state.time, found, scene_.end.settled));
  if (is_settled(snapshot, found)) return run::End{};
  if (question.may_soften)
    if (const auto to =
            softening(snapshot, found, ending::horizon(scene_.end, snapshot.state.time));
        to != snapshot.state.softening)
      return run::Soften{to};
  if (may_fly(scene_))
    if (auto landing = ending::flight_from(snapshot, question.until, looks_.rows(), found,
                                           [this] { return stop_(); }))
      return run::Fly{*std::move(landing)};
  return run::GoOn{};
}

/// Several remnants about a primary meet or part by orbits that nobody predicts.
bool Watch::is_unpredictable(const remnants::Remnants& found) const {
  return has_primary(scene_) && ending::look(0, found, scene_.end.settled).size() > 1;
}

bool Watch::is_settled(const io::Snapshot& snapshot, const remnants::Remnants& found) const {
  if (is_unpredictable(found)) return false;
  const double mass = snapshot.state.mass * static_cast<double>(snapshot.state.size());
  return ending::encounters(found, mass, ending::horizon(scene_.end, snapshot.state.time),
                            scene_.end.settled)
             .empty() &&
         ending::unsteadiness(looks_.rows(), scene_.end.settled).empty();
}

particles::Softening Watch::softening(const io::Snapshot& snapshot, const remnants::Remnants& found,
                                      double horizon) {
  const particles::Softening now = snapshot.state.softening;
  if (is_unpredictable(found)) return {};
  if (may_fly(scene_) && ending::impact_ahead(found, scene_.end.settled)) return now;
  const double late = softest_sound_speed(scene_), sound = bulk_sound_speed(scene_);
  if (ending::liveliness(looks_.rows(), found, horizon, late * sound, scene_.end.settled).empty())
    return {late, true};
  const bool is_softest = now.sound_speed <= power_of_half_from(late);
  if (scene_.numerics.flow_mach == 0 || is_softest) return now;
  const double fastest =
      std::max(ending::meeting_speed(found, horizon, scene_.end.settled), flow_speed_in(snapshot));
  const double needed = fastest / (scene_.numerics.flow_mach * sound);
  return {std::min(now.sound_speed, power_of_half_from(std::max(needed, late))), false};
}

/// What is ahead counts up to the end of the run. More of it is seen where that is later, so an
/// answer that is the same for the whole horizon is the same for every later end.
bool Watch::end_matters(const io::Snapshot& snapshot, const run::LookQuestion& question) {
  const Scene::Settled& settled = scene_.end.settled;
  const double seen = ending::horizon(scene_.end, snapshot.state.time), all = settled.horizon_s;
  const double mass = snapshot.state.mass * static_cast<double>(snapshot.state.size());
  const auto is_ahead = [&](double horizon) {
    return !ending::encounters(found_, mass, horizon, settled).empty();
  };
  // A flight lasts until nothing is ahead, asked again on its way, where less time is left.
  if (may_fly(scene_) && ending::restlessness(looks_.rows(), settled).empty() && is_ahead(all))
    return true;
  if (seen >= all) return false;
  if (ending::unsteadiness(looks_.rows(), settled).empty() && is_ahead(seen) != is_ahead(all))
    return true;
  return question.may_soften &&
         softening(snapshot, found_, seen) != softening(snapshot, found_, all);
}

}  // namespace eerie::worker
