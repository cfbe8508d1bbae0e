#include "campaign/worker/worker.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "analysis/ending/may_fly.hpp"
#include "analysis/ending/steadiness.hpp"
#include "analysis/remnants/meetings.hpp"
#include "campaign/job_folder/heartbeat.hpp"
#include "campaign/job_folder/history.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/log.hpp"
#include "campaign/job_folder/provenance.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "campaign/job_folder/worker_exit.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/text/json_file.hpp"
#include "campaign/worker/reanalysis.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/simd.hpp"
#include "solver/scene/guards.hpp"
#include "solver/step/diagnosis.hpp"

namespace eerie::worker {
namespace fs = std::filesystem;

namespace {

/// A worker whose manager is gone stops: the next manager starts it again from its checkpoint.
/// Returns false where the manager was gone before this call.
bool die_with(long parent) {
  if (parent == 0) return true;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  return ::getppid() == parent;
}

/// Whether a stop was asked for: by a signal, or, from another host, by the file `stop` in the
/// job directory, looked for once a second.
class StopRequest {
 public:
  explicit StopRequest(fs::path file) : file_(std::move(file)) {}

  bool operator()() {
    if (process::stop_requests() > 0) return true;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::seconds(1)) return found_;
    last_ = now;
    std::error_code ignored;
    return found_ = fs::exists(file_, ignored);
  }

 private:
  fs::path file_;
  std::chrono::steady_clock::time_point last_{};
  bool found_ = false;
};

/// Installs progress.json about once a second of wall time.
class ProgressWriter {
 public:
  ProgressWriter(job_folder::JobDirectory directory, const Scene& scene)
      : directory_(std::move(directory)), expected_end_s_(sweeps::expected_end_s(scene)) {}

  void operator()(const run::Progress& p) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::seconds(1)) return;
    last_ = now;
    const job_folder::WorkerProgress report{
        p.time,   p.end_time, std::min(expected_end_s_, p.end_time), p.step, p.particle_steps,
        p.wall_s, ::getpid()};
    try {
      install_text(directory_.progress(), job_folder::to_json(report).dump());
    } catch (const EnvironmentError& error) {
      spdlog::warn("no progress noted: {}", error.what());  // the run itself may still succeed
    }
  }

 private:
  job_folder::JobDirectory directory_;
  double expected_end_s_;
  std::chrono::steady_clock::time_point last_{};
};

/// The remnants of the state that was asked about last: one look asks more than one question.
class LatestRemnants {
 public:
  const remnants::Remnants& of(const particles::State& state) {
    if (state.time != time_) found_ = remnants::find_remnants(state), time_ = state.time;
    return found_;
  }

 private:
  double time_ = -1;
  remnants::Remnants found_;
};

/// Everything that a row of the history says of a state.
job_folder::HistoryRow full_row(const io::Snapshot& snapshot, const step::Totals& start) {
  job_folder::HistoryRow row =
      job_folder::history_row(snapshot.state.time, remnants::analyse(snapshot));
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

/// The same scene would fail again: that is the verdict on the job.
int fail(const job_folder::JobDirectory& directory, const job_folder::Failure& failure) {
  spdlog::error("step {}: {}", failure.step, failure.message);
  install_text(directory.failure(), job_folder::to_json(failure).dump(1) + "\n");
  return static_cast<int>(ExitCode::job_failed);
}

int run_job(const job_folder::JobDirectory& directory, int threads) {
  const Scene scene = parse_scene(text::load_json(directory.scene()), directory.scene().string());
  if (job_folder::read_result(directory, scene_hash(scene))) {
    spdlog::info("the result is here already: nothing to do");
    return static_cast<int>(ExitCode::done);
  }
  for (const std::string& warning : warnings(scene)) spdlog::warn("{}", warning);
  fs::remove(directory.failure());
  try {
    const Computed computed =
        compute(scene, directory.path, threads, 0, ProgressWriter(directory, scene));
    if (computed.summary.end != run::RunEnd::finished) {
      spdlog::info("stopped at {:.6g} s, step {}: the checkpoint is written",
                   computed.summary.progress.time, computed.summary.progress.step);
      return job_folder::worker_stopped;
    }
    install_text(
        directory.result(),
        job_folder::result_json(scene, computed.summary, computed.analysis).dump(1) + "\n");
    fs::remove(directory.checkpoint());
    fs::remove(directory.previous_checkpoint());
    spdlog::info("done: {} steps in {:.1f} s", computed.summary.progress.step,
                 computed.summary.progress.wall_s);
    return static_cast<int>(ExitCode::done);
  } catch (const NumericalError& error) {
    return fail(directory, {error.kind, error.step, error.particle_id, error.what()});
  } catch (const InputError& error) {
    return fail(directory, {"bad-input", 0, -1, error.what()});
  }
}

/// The last word of a worker, for whoever did not see it end.
void write_ended(const job_folder::JobDirectory& directory, int exit_code) {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  const job_folder::AttemptEnded ended{exit_code, seconds(usage.ru_utime) + seconds(usage.ru_stime),
                                       static_cast<std::int64_t>(usage.ru_maxrss) * 1024,
                                       job_folder::host_name(), ::getpid()};
  try {
    install_text(directory.ended(), job_folder::to_json(ended).dump());
  } catch (const EnvironmentError& error) {
    spdlog::warn("no last word: {}", error.what());  // the exit code says the same
  }
}

/// run_job with its failures that are no verdict on the job as exit codes.
int run_or_excuse(const job_folder::JobDirectory& directory, int threads) {
  try {
    return run_job(directory, threads);
  } catch (const DiskFullError& error) {
    spdlog::error("{}", error.what());
    return job_folder::worker_disk_full;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return static_cast<int>(dynamic_cast<const InputError*>(&error) != nullptr
                                ? ExitCode::bad_input
                                : ExitCode::environment);
  }
}

int attempt(const job_folder::JobDirectory& directory, int threads) {
  job_folder::open_log(directory);
  const job_folder::Provenance source = job_folder::provenance();
  spdlog::info("eerie {} ({}) on {}, process {}, {} threads, {}", source.version, source.commit,
               source.host, ::getpid(), threads, vector_variant);
  const job_folder::Heartbeat heartbeat(directory.heartbeat());
  const int exit_code = run_or_excuse(directory, threads);
  write_ended(directory, exit_code);
  return exit_code;
}

}  // namespace

Computed compute(const Scene& scene, const fs::path& directory, int threads, long max_steps,
                 const std::function<void(const run::Progress&)>& on_progress) {
  job_folder::History history(job_folder::JobDirectory{directory}.history());
  run::RunOptions options;
  options.directory = directory;
  options.threads = threads;
  options.max_steps = max_steps;
  options.on_progress = on_progress;
  options.on_history = [&](const io::Snapshot& snapshot, const step::Totals& start) {
    history.add({full_row(snapshot, start)});
  };
  LatestRemnants latest;
  options.will_meet = [&](const io::Snapshot& snapshot) {
    return remnants::will_meet(latest.of(snapshot.state).remnants, scene.end.settled.fall_back);
  };
  job_folder::RowLog<ending::RemnantLook> looks(job_folder::JobDirectory{directory}.remnants());
  options.settled = [&](const io::Snapshot& snapshot) {
    const remnants::Remnants& found = latest.of(snapshot.state);
    looks.add(ending::look(snapshot.state.time, found, scene.end.settled));
    const double mass = snapshot.state.mass * static_cast<double>(snapshot.state.size());
    return ending::encounters(found, mass, ending::horizon(scene.end, snapshot.state.time),
                              scene.end.settled)
               .empty() &&
           ending::unsteadiness(looks.rows(), scene.end.settled).empty();
  };
  options.calm = [&](const io::Snapshot& snapshot) {
    const remnants::Remnants& found = latest.of(snapshot.state);
    if (scene.numerics.rigid_flight && ending::impact_ahead(found, scene.end.settled)) return false;
    return ending::liveliness(looks.rows(), found, ending::horizon(scene.end, snapshot.state.time),
                              scene.numerics.late_sound_speed * bulk_sound_speed(scene),
                              scene.end.settled)
        .empty();
  };
  options.stop = StopRequest(job_folder::JobDirectory{directory}.stop());
  if (scene.numerics.rigid_flight)
    options.fly = [&](const io::Snapshot& snapshot, double until) {
      return ending::flight_from(snapshot, until, looks.rows(), latest.of(snapshot.state),
                                 options.stop);
    };
  options.on_note = [](const std::string& note) { spdlog::info("{}", note); };
  Computed computed;
  computed.summary = run::run_impact(scene, options);
  computed.analysis =
      analyse_run(job_folder::JobDirectory{directory}, computed.summary.last, history.rows());
  return computed;
}

int run_worker(const WorkerOptions& options) {
  process::catch_stop_signals();
  if (!die_with(options.parent)) return job_folder::worker_stopped;
  const job_folder::JobDirectory directory{options.directory};
  try {
    const job_folder::WorkerLock lock(directory);
    return attempt(directory, options.threads);
  } catch (const job_folder::DirectoryBusy& error) {
    fmt::print(stderr, "{}\n", error.what());
    return job_folder::worker_busy;
  }
}

}  // namespace eerie::worker
