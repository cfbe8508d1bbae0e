#include "analysis/drawing/tool.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "solver/base/error.hpp"

namespace eerie::drawing {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A nameless file that is gone when closed; it cannot fill up and block as a pipe does.
File nameless() {
  File file(std::tmpfile(), std::fclose);
  if (!file)
    throw EnvironmentError(fmt::format("cannot make a temporary file: {}", std::strerror(errno)));
  return file;
}

std::string content(std::FILE* file) {
  std::rewind(file);
  std::string text;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), file)) > 0;)
    text.append(buffer.data(), n);
  return text;
}

EnvironmentError not_installed(const Tool& tool) {
  return EnvironmentError(fmt::format("{} is not installed and {}; install it: apt-get install {}",
                                      tool.program, tool.use, tool.package));
}

/// Its wait status, with these three files for stdin, stdout and stderr.
int spawn_and_wait(const Tool& tool, std::vector<std::string> words, int in, int out, int err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t pid = 0;
  const int error =
      ::posix_spawnp(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) throw not_installed(tool);
  if (error != 0)
    throw EnvironmentError(fmt::format("cannot start {}: {}", tool.program, std::strerror(error)));
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0)
    if (errno != EINTR)
      throw EnvironmentError(
          fmt::format("cannot wait for {}: {}", tool.program, std::strerror(errno)));
  return status;
}

}  // namespace

ToolEnd run_tool(const Tool& tool, const std::vector<std::string>& arguments,
                 std::string_view input, const std::filesystem::path& output) {
  const File in = nameless(), err = nameless();
  // Of an empty text data() may be null, which fwrite() does not take.
  const bool is_written =
      input.empty() || std::fwrite(input.data(), 1, input.size(), in.get()) == input.size();
  if (!is_written || std::fflush(in.get()) != 0)
    throw EnvironmentError(
        fmt::format("cannot write the input of {}: {}", tool.program, std::strerror(errno)));
  std::rewind(in.get());
  const std::string where = output.empty() ? "/dev/null" : output.string();
  const File out(std::fopen(where.c_str(), "w+e"), std::fclose);
  if (!out)
    throw EnvironmentError(fmt::format("cannot create {}: {}", where, std::strerror(errno)));
  std::vector<std::string> words = {tool.program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int status = spawn_and_wait(tool, std::move(words), ::fileno(in.get()), ::fileno(out.get()),
                                    ::fileno(err.get()));
  return {status == 0, content(err.get())};
}

void require_tool(const Tool& tool) {
  const char* path = std::getenv("PATH");
  const std::string folders = path != nullptr ? path : "";
  for (std::size_t from = 0; from <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', from), folders.size());
    const std::filesystem::path candidate =
        std::filesystem::path(folders.substr(from, end - from)) / tool.program;
    if (::access(candidate.c_str(), X_OK) == 0) return;
    from = end + 1;
  }
  throw not_installed(tool);
}

}  // namespace eerie::drawing
