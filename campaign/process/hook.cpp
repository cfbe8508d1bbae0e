#include "campaign/process/hook.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "solver/base/error.hpp"

namespace eerie::process {
namespace fs = std::filesystem;

namespace {

bool is_program(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

/// As execvp() would, but before there is anything to be told.
std::string found(const std::string& program) {
  if (program.find('/') != std::string::npos)
    return is_program(program) ? fs::absolute(program).string() : "";
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path candidate = fs::path(folder) / program; is_program(candidate))
      return fs::absolute(candidate).string();
  return "";
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> environment_with(const Hook::Facts& facts) {
  std::vector<std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (!std::string_view(*entry).starts_with("EERIE_")) variables.emplace_back(*entry);
  for (const auto& [name, value] : facts) variables.push_back(name + "=" + value.c_str());
  return variables;
}

/// In a child: becomes the program, with signals as new. Only what is safe after a fork.
[[noreturn]] void become(const char* path, char* const* words, char* const* variables, int report) {
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  ::setsid();  // Ctrl-C of the terminal is not meant for it
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  ::execve(path, words, variables);
  const int problem = errno;
  [[maybe_unused]] const ssize_t written = ::write(report, &problem, sizeof problem);
  ::_exit(127);
}

}  // namespace

Hook::Hook(const std::string& program) {
  if (program.empty()) return;
  path_ = found(program);
  if (path_.empty())
    throw InputError(fmt::format(
        "--notify {}: there is no such program; give the path of one, such as a script with "
        "execute permission. It is run without a shell, so it takes no arguments here",
        program));
}

std::string Hook::tell(const std::string& event, const Facts& facts) const {
  if (path_.empty()) return "";
  std::vector<std::string> words = {path_, event}, variables = environment_with(facts);
  const std::vector<char*> argv = pointers_to(words), envp = pointers_to(variables);
  int report[2];
  if (::pipe2(report, O_CLOEXEC) != 0) return std::strerror(errno);
  // A child of a child: init takes it over, so that nobody has to wait for its end.
  const pid_t child = ::fork();
  if (child == 0) {
    if (const pid_t inner = ::fork(); inner != 0) ::_exit(inner > 0 ? 0 : 1);
    become(path_.c_str(), argv.data(), envp.data(), report[1]);
  }
  int problem = child < 0 ? errno : 0, status = 0;
  ::close(report[1]);
  if (child > 0) {
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (status != 0) problem = EAGAIN;
    // Ends when the program runs, for then the other end is closed.
    int said = 0;
    if (::read(report[0], &said, sizeof said) == sizeof said) problem = said;
  }
  ::close(report[0]);
  return problem == 0 ? "" : fmt::format("{}: {}", path_, std::strerror(problem));
}

}  // namespace eerie::process
