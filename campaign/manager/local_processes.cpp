#include "campaign/manager/local_processes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/process/environment.hpp"
#include "campaign/process/signals.hpp"
#include "solver/base/error.hpp"

namespace eerie::manager {
namespace {

constexpr const char* program_of_workers = "/proc/self/exe";

/// No patience helps where workers can never be started.
void require_program() {
  struct Need {
    const char *path, *mount;
    int way;
  };
  for (const Need& need :
       {Need{program_of_workers, "/proc", X_OK}, Need{"/dev/null", "/dev", R_OK}})
    if (::access(need.path, need.way) != 0)
      throw EnvironmentError(fmt::format("workers cannot be started: {}: {}; mount {}", need.path,
                                         std::strerror(errno), need.mount));
}

/// posix_spawn's settings for a worker: input empty, output to the log, signals as new, and a
/// process group of its own so that Ctrl-C reaches the manager alone.
class SpawnSettings {
 public:
  explicit SpawnSettings(const std::string& log) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_APPEND, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_init(&attributes);
    sigset_t none, defaults;
    sigemptyset(&none);
    sigemptyset(&defaults);
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGCHLD, SIGPIPE})
      sigaddset(&defaults, signal);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(
        &attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

WorkerEnd worker_end(std::int64_t job, int status, const rusage& usage) {
  WorkerEnd end;
  end.job = job;
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  end.core_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.peak_memory_bytes = static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
  return end;
}

}  // namespace

LocalProcesses::LocalProcesses(std::size_t workers, int threads_per_job)
    : workers_(workers), threads_per_job_(threads_per_job) {
  require_program();
}

LocalProcesses::~LocalProcesses() {
  for (const auto& [pid, job] : jobs_) ::kill(pid, SIGKILL);
  while (!jobs_.empty() && !wait(std::chrono::seconds(1)).empty()) {
  }
}

std::vector<std::string> LocalProcesses::start(std::span<const Task> tasks) {
  std::vector<std::string> names;
  for (const Task& task : tasks) {
    const pid_t pid = spawn(task.directory);
    jobs_[pid] = task.job;
    names.push_back(std::to_string(pid));
  }
  return names;
}

pid_t LocalProcesses::spawn(const job_folder::JobDirectory& directory) const {
  std::string words[] = {"eerie",
                         "worker",
                         std::filesystem::absolute(directory.path).string(),  // no option
                         "--threads",
                         std::to_string(threads_per_job_),
                         "--parent",
                         std::to_string(::getpid())};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const SpawnSettings settings(directory.log().string());
  const process::Environment environment = process::environment_for_workers();
  pid_t pid = 0;
  const int status =
      ::posix_spawn(&pid, program_of_workers, &settings.actions, &settings.attributes,
                    arguments.data(), environment.passed_on.data());
  if (status != 0)
    throw SchedulerUnavailable(fmt::format("cannot start a worker in {}: {}",
                                           directory.path.string(), std::strerror(status)));
  return pid;
}

bool LocalProcesses::holds(const Task& task) {
  return job_folder::WorkerLock::held(task.directory);
}

std::vector<WorkerEnd> LocalProcesses::wait(std::chrono::milliseconds longest) {
  std::vector<WorkerEnd> ended = reap();
  if (!ended.empty() || longest.count() == 0) return ended;
  process::wait_for_signal(longest);
  return reap();
}

std::vector<WorkerEnd> LocalProcesses::reap() {
  std::vector<WorkerEnd> ended;
  for (auto entry = jobs_.begin(); entry != jobs_.end();) {
    int status = 0;
    rusage usage{};
    if (::wait4(entry->first, &status, WNOHANG, &usage) == entry->first) {
      ended.push_back(worker_end(entry->second, status, usage));
      entry = jobs_.erase(entry);
    } else {
      ++entry;
    }
  }
  return ended;
}

void LocalProcesses::stop(std::span<const Task> tasks, StopKind kind) {
  const int signal = kind == StopKind::at_once ? SIGKILL : SIGTERM;
  for (const auto& [pid, job] : jobs_)
    if (std::ranges::find(tasks, job, &Task::job) != tasks.end()) {
      ::kill(pid, signal);
      ::kill(pid, SIGCONT);  // one that was halted cannot hear the other
    }
}

}  // namespace eerie::manager
