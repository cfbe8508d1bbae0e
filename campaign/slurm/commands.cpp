#include "campaign/slurm/commands.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>

#include "campaign/process/environment.hpp"
#include "solver/base/error.hpp"

namespace eerie::slurm {
namespace {

using Clock = std::chrono::steady_clock;

/// The reading end is ours alone.
class Pipe {
 public:
  Pipe() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
      throw EnvironmentError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    read_end = ends[0], write_end = ends[1];
  }
  ~Pipe() {
    ::close(read_end);
    close_write_end();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void close_write_end() {
    if (write_end >= 0) ::close(write_end);
    write_end = -1;
  }

  int read_end = -1, write_end = -1;
};

/// Input empty, output into the pipes, signals as new, a process group of its own: Ctrl-C does not
/// reach a command in the middle of a submission.
pid_t spawn(const std::vector<std::string>& words, const Pipe& out, const Pipe& err, int& problem) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.write_end, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.write_end, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  // A user's own defaults would hide jobs from us, or send them elsewhere.
  const process::Environment environment = process::environment_for_slurm();
  pid_t pid = 0;
  problem = ::posix_spawnp(&pid, arguments[0], &actions, &attributes, arguments.data(),
                           environment.passed_on.data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return pid;
}

/// Reads both pipes until they end; false where the time is over first.
bool read_all(const Pipe& out, const Pipe& err, CommandEnd& end, Clock::time_point deadline) {
  pollfd sources[] = {{out.read_end, POLLIN, 0}, {err.read_end, POLLIN, 0}};
  std::string* texts[] = {&end.out, &end.err};
  while (sources[0].fd >= 0 || sources[1].fd >= 0) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    if (::poll(sources, 2, static_cast<int>(left)) < 0 && errno != EINTR) return false;
    for (int k = 0; k < 2; ++k) {
      if (sources[k].fd < 0 || sources[k].revents == 0) continue;
      char buffer[1 << 16];
      const ssize_t bytes = ::read(sources[k].fd, buffer, sizeof buffer);
      if (bytes > 0)
        texts[k]->append(buffer, static_cast<std::size_t>(bytes));
      else if (bytes == 0 || errno != EINTR)
        sources[k].fd = -1;
      sources[k].revents = 0;
    }
  }
  return true;
}

}  // namespace

std::string CommandEnd::complaint() const {
  if (timed_out) return "it did not answer in time";
  std::string_view text = err.find_first_not_of(" \n") == std::string::npos ? out : err;
  while (text.ends_with('\n')) text.remove_suffix(1);
  constexpr std::size_t longest = 500;
  if (text.size() > longest) text.remove_prefix(text.size() - longest);
  return text.empty() ? fmt::format("it ended with code {}", exit_code) : std::string(text);
}

CommandEnd ChildCommands::run(const std::vector<std::string>& words,
                              std::chrono::milliseconds limit) {
  const auto deadline = Clock::now() + limit;
  CommandEnd end;
  Pipe out, err;
  int problem = 0;
  const pid_t pid = spawn(words, out, err, problem);
  if (problem != 0) {
    end.err = fmt::format("cannot start {}: {}", words[0], std::strerror(problem));
    return end;
  }
  out.close_write_end();
  err.close_write_end();
  if (!read_all(out, err, end, deadline)) {
    end.timed_out = true;
    ::kill(-pid, SIGKILL);
  }
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (!end.timed_out && WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  return end;
}

}  // namespace eerie::slurm
