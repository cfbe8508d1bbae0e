#include "campaign/worker/worker.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <spdlog/spdlog.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/heartbeat.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/log.hpp"
#include "campaign/job_folder/provenance.hpp"
#include "campaign/job_folder/result_file.hpp"
#include "campaign/job_folder/worker_exit.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/sweeps/job.hpp"
#include "campaign/text/json_file.hpp"
#include "campaign/text/json_text.hpp"
#include "campaign/worker/reanalysis.hpp"
#include "campaign/worker/watch.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/simd/pack.hpp"
#include "solver/scene/guards.hpp"

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
      show_text(directory_.progress(), job_folder::to_json(report).dump());
    } catch (const EnvironmentError& error) {
      spdlog::warn("no progress noted: {}", error.what());  // the run itself may still succeed
    }
  }

 private:
  job_folder::JobDirectory directory_;
  double expected_end_s_;
  std::chrono::steady_clock::time_point last_{};
};

/// The same scene would fail again: that is the verdict on the job.
int fail(const job_folder::JobDirectory& directory, const job_folder::Failure& failure) {
  spdlog::error("step {}: {}", failure.step, failure.message);
  install_text(directory.failure(), text::json_text(job_folder::to_json(failure), 1) + "\n");
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
    const Computed computed = compute(scene, directory.path, threads, 0,
                                      ProgressWriter(directory, scene), directory.shared_bodies());
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
    for (const std::string& warning : job_folder::run_warnings(scene, computed.summary))
      spdlog::warn("{}", warning);
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
                 const std::function<void(const run::Progress&)>& on_progress,
                 const fs::path& bodies) {
  const job_folder::JobDirectory folder{directory};
  Watch watch(scene, folder);
  Computed computed;
  run::RunOptions options = watch.options(threads, max_steps, on_progress);
  options.bodies = bodies;
  computed.summary = run::run_impact(scene, options);
  computed.analysis = analyse_run(folder, computed.summary.last, watch.history());
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
