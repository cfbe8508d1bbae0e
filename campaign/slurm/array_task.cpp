#include "campaign/slurm/array_task.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <charconv>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "campaign/job_folder/provenance.hpp"
#include "campaign/job_folder/worker_exit.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/manager/local_processes.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/slurm/batch.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"

namespace eerie::slurm {
namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds tick{500};

/// A worker beats every 5 s; one that was cut off from its manager may hold its lock for ever.
constexpr std::chrono::seconds silence{60};

int number_in(const char* variable, int missing) {
  const char* text = std::getenv(variable);
  if (text == nullptr) return missing;
  const std::string_view digits = text;
  int value = -1;
  const auto [stop, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (problem != std::errc{} || stop != digits.data() + digits.size()) return -1;
  return value;
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

/// Notes an attempt's end for a worker that could not: it was killed, or never began.
void note_end(const job_folder::JobDirectory& directory, const manager::WorkerEnd& end) {
  if (is_there(directory.ended())) return;
  job_folder::AttemptEnded note;
  note.exit_code = end.signal != 0 ? 128 + end.signal : end.exit_code;
  note.core_seconds = end.core_seconds.value_or(0);
  note.peak_memory_bytes = end.peak_memory_bytes.value_or(0);
  note.host = job_folder::host_name();
  install_text(directory.ended(), job_folder::to_json(note).dump(1) + "\n");
}

void note_not_started(const BatchJob& job) {
  manager::WorkerEnd end;
  end.exit_code = job_folder::worker_stopped;
  note_end(job.directory, end);
}

/// A worker of an earlier start of this array task may still be at it, on a node that Slurm has
/// given up. Waits for its end, as long as it gives signs of life.
void wait_for_other(const job_folder::JobDirectory& directory) {
  using Clock = std::chrono::steady_clock;
  auto last_sign = Clock::now();
  std::error_code ignored;
  auto beat = fs::last_write_time(directory.heartbeat(), ignored);
  while (job_folder::WorkerLock::held(directory) && process::stop_requests() == 0 &&
         Clock::now() < last_sign + silence) {
    process::wait_for_signal(tick);
    const auto newest = fs::last_write_time(directory.heartbeat(), ignored);
    if (newest != beat) beat = newest, last_sign = Clock::now();
  }
}

void run_job(const BatchJob& job, manager::LocalProcesses& processes) {
  fs::remove(job.directory.ended());
  const manager::Task one[] = {{job.job, job.directory}};
  processes.start(one);
  int told = 0;
  while (true) {
    for (manager::WorkerEnd end : processes.wait(tick)) {
      // Told to stop before it could listen, it dies of the signal.
      if (told > 0 && end.signal == SIGTERM)
        end.signal = 0, end.exit_code = job_folder::worker_stopped;
      note_end(job.directory, end);
      return;
    }
    if (process::stop_requests() > told) {
      told = process::stop_requests();
      processes.stop(one, manager::StopKind::with_checkpoint);
    }
  }
}

}  // namespace

ArrayTaskOptions array_task_options(fs::path batch) {
  ArrayTaskOptions options;
  options.batch = std::move(batch);
  options.index = number_in("SLURM_ARRAY_TASK_ID", -1);
  options.threads = number_in("SLURM_CPUS_PER_TASK", 1);
  if (options.index < 0 || options.threads < 1)
    throw InputError(
        "slurm-task is started by Slurm, which sets SLURM_ARRAY_TASK_ID to a number "
        "from 0 on and SLURM_CPUS_PER_TASK to one from 1 on");
  return options;
}

int run_array_task(const ArrayTaskOptions& options) {
  process::catch_stop_signals();
  process::hold_signals();
  const auto batch = read_batch(options.batch);
  const auto index = static_cast<std::size_t>(options.index);
  if (!batch || index >= batch->array.size()) {
    fmt::print("{}: nothing to do: its manager has given this batch up\n", options.batch.string());
    return 0;
  }
  manager::LocalProcesses processes(1, options.threads);
  for (const BatchJob& job : batch->array[index]) {
    // Asked anew each time: the manager may have taken a job back, or the whole batch.
    if (!is_there(batch->manifest()) || read_released(*batch).contains(job.job)) continue;
    if (process::stop_requests() == 0) wait_for_other(job.directory);
    if (is_there(job.directory.result()) || is_there(job.directory.failure())) continue;
    if (process::stop_requests() > 0 || is_there(job.directory.stop()))
      note_not_started(job);
    else
      run_job(job, processes);
  }
  return process::stop_requests() > 0 ? job_folder::worker_stopped : 0;
}

}  // namespace eerie::slurm
