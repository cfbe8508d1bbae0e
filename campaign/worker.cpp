#include "campaign/worker.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "analysis/settled.hpp"
#include "campaign/heartbeat.hpp"
#include "campaign/history.hpp"
#include "campaign/job_directory.hpp"
#include "campaign/json_file.hpp"
#include "campaign/log.hpp"
#include "campaign/provenance.hpp"
#include "campaign/result_file.hpp"
#include "campaign/signals.hpp"
#include "campaign/worker_lock.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/simd.hpp"
#include "solver/scene/guards.hpp"
#include "solver/step/diagnosis.hpp"

namespace eerie {
namespace fs = std::filesystem;

namespace {

/// A worker whose manager is gone stops: the next manager starts it again from its checkpoint.
/// Returns false where the manager was gone before this call.
bool die_with(long parent) {
  if (parent == 0) return true;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  return ::getppid() == parent;
}

/// Installs progress.json about once a second of wall time.
class ProgressWriter {
 public:
  explicit ProgressWriter(JobDirectory directory) : directory_(std::move(directory)) {}

  void operator()(const Progress& p) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::seconds(1)) return;
    last_ = now;
    const WorkerProgress report{p.time, p.end_time, p.step, p.particle_steps, p.wall_s, ::getpid()};
    install_text(directory_.progress(), to_json(report).dump());
  }

 private:
  JobDirectory directory_;
  std::chrono::steady_clock::time_point last_{};
};

/// Everything that a row of the history says of a state.
HistoryRow full_row(const Snapshot& snapshot, const Totals& start) {
  HistoryRow row = history_row(snapshot.state.time, analyse(snapshot));
  const Totals t = totals(snapshot.scene, snapshot.state);
  row.kinetic_energy_J = t.kinetic_energy, row.potential_energy_J = t.potential_energy;
  row.internal_energy_J = t.internal_energy, row.viscous_heat_J = t.viscous_heat;
  row.friction_heat_J = t.friction_heat, row.shear_energy_J = t.shear_energy;
  row.dL_over_L = angular_momentum_drift(snapshot.scene, start, t).value_or(0);
  const Diagnosis d = diagnose(snapshot);
  row.eos_pressure_Pa = d.eos_pressure, row.viscous_pressure_Pa = d.viscous_pressure;
  row.pressureless = d.pressureless, row.density_kg_per_m3 = d.density;
  row.summed_density_kg_per_m3 = d.summed_density, row.density_error = d.density_error;
  return row;
}

int run_job(const JobDirectory& directory, int threads) {
  const Scene scene = parse_scene(load_json(directory.scene()), directory.scene().string());
  if (read_result(directory, scene_hash(scene))) {
    spdlog::info("the result is here already: nothing to do");
    return static_cast<int>(ExitCode::done);
  }
  for (const std::string& warning : warnings(scene)) spdlog::warn("{}", warning);
  fs::remove(directory.failure());
  try {
    const Computed computed = compute(scene, directory.path, threads, 0, ProgressWriter(directory));
    if (computed.summary.end != RunEnd::finished) {
      spdlog::info("stopped at {:.6g} s, step {}: the checkpoint is written",
                   computed.summary.progress.time, computed.summary.progress.step);
      return worker_stopped;
    }
    install_text(directory.result(),
                 result_json(scene, computed.summary, computed.analysis).dump(1) + "\n");
    fs::remove(directory.checkpoint());
    fs::remove(directory.previous_checkpoint());
    spdlog::info("done: {} steps in {:.1f} s", computed.summary.progress.step,
                 computed.summary.progress.wall_s);
    return static_cast<int>(ExitCode::done);
  } catch (const NumericalError& error) {
    spdlog::error("step {}: {}", error.step, error.what());
    install_text(
        directory.failure(),
        to_json(Failure{error.kind, error.step, error.particle_id, error.what()}).dump(1) + "\n");
    return static_cast<int>(ExitCode::job_failed);
  }
}

}  // namespace

Computed compute(const Scene& scene, const fs::path& directory, int threads, long max_steps,
                 const std::function<void(const Progress&)>& on_progress) {
  History history(JobDirectory{directory}.history());
  RunOptions options;
  options.directory = directory;
  options.threads = threads;
  options.max_steps = max_steps;
  options.on_progress = on_progress;
  options.on_history = [&](const Snapshot& snapshot, const Totals& start) {
    history.add(full_row(snapshot, start));
  };
  options.settled = [](const Snapshot& snapshot) {
    return !will_meet(find_remnants(snapshot.state).remnants);
  };
  options.stop = [] { return stop_requests() > 0; };
  options.on_note = [](const std::string& note) { spdlog::info("{}", note); };
  Computed computed;
  computed.summary = run_impact(scene, options);
  computed.analysis =
      analyse(computed.summary.last, separated_after_contact(history.rows(), scene.impact.q));
  return computed;
}

int run_worker(const WorkerOptions& options) {
  catch_stop_signals();
  if (!die_with(options.parent)) return worker_stopped;
  const JobDirectory directory{options.directory};
  const WorkerLock lock(directory);
  open_log(directory);
  const Provenance source = provenance();
  spdlog::info("eerie {} ({}) on {}, process {}, {} threads, {}", source.version, source.commit,
               source.host, ::getpid(), options.threads, vector_variant);
  const Heartbeat heartbeat(directory.heartbeat());
  try {
    return run_job(directory, options.threads);
  } catch (const std::exception& error) {
    // Not a verdict on the job: the manager sees the exit code and tries again.
    spdlog::error("{}", error.what());
    throw;
  }
}

}  // namespace eerie
