#include "tests/support/streams.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "solver/base/file.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/paths.hpp"

namespace eerie::test {
namespace fs = std::filesystem;

namespace {

/// The test's own without what says how wide a terminal is, and of which kind.
std::vector<std::string> environment_with(const std::string& kind) {
  std::vector<std::string> all = {"TERM=" + kind};
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (const std::string text = *entry;
        !text.starts_with("TERM=") && !text.starts_with("COLUMNS="))
      all.push_back(text);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

pid_t spawn(const fs::path& folder, const std::vector<std::string>& arguments, int out, int err,
            const std::string& kind = "dumb") {
  std::vector<std::string> words = {"eerie"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environment_with(kind);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  pid_t pid = 0;
  EXPECT_EQ(::posix_spawn(&pid, program().c_str(), &actions, nullptr, pointers(words).data(),
                          pointers(environment).data()),
            0);
  posix_spawn_file_actions_destroy(&actions);
  return pid;
}

int code_of(pid_t pid) {
  int status = 0;
  ::waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The writing end of a pipe whose reader has gone.
int closed_pipe() {
  std::array<int, 2> ends{};
  EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  ::close(ends[0]);
  return ends[1];
}

/// Runs it with one stream on `descriptor` and the other in a file.
std::pair<int, std::string> with(const fs::path& folder, const std::vector<std::string>& arguments,
                                 int descriptor, bool as_output) {
  const TemporaryFolder outside;
  const fs::path kept = outside / "kept";
  const int file = ::open(kept.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  const int code = code_of(as_output ? spawn(folder, arguments, descriptor, file)
                                     : spawn(folder, arguments, file, descriptor));
  ::close(file);
  ::close(descriptor);
  return {code, read_file(kept)};
}

}  // namespace

Ended on_full_disk(const fs::path& folder, const std::vector<std::string>& arguments) {
  const auto [code, err] = with(folder, arguments, ::open("/dev/full", O_WRONLY | O_CLOEXEC), true);
  return {code, "", err};
}

Ended into_closed_pipe(const fs::path& folder, const std::vector<std::string>& arguments) {
  const auto [code, err] = with(folder, arguments, closed_pipe(), true);
  return {code, "", err};
}

Ended complaining_to_nobody(const fs::path& folder, const std::vector<std::string>& arguments) {
  const auto [code, out] = with(folder, arguments, closed_pipe(), false);
  return {code, out, ""};
}

Ended on_terminal(const fs::path& folder, const std::vector<std::string>& arguments,
                  const FakeTerminal& terminal) {
  const winsize size{24, terminal.columns, 0, 0};
  int master = -1, slave = -1;
  EXPECT_EQ(::openpty(&master, &slave, nullptr, nullptr, &size), 0);
  ::fcntl(master, F_SETFD, FD_CLOEXEC);
  const pid_t pid = spawn(folder, arguments, slave, slave, terminal.kind);
  ::close(slave);
  Ended ended;
  std::array<char, 4096> chunk{};
  for (ssize_t n; (n = ::read(master, chunk.data(), chunk.size())) > 0;)
    ended.out.append(chunk.data(), static_cast<std::size_t>(n));
  ::close(master);
  ended.code = code_of(pid);
  return ended;
}

}  // namespace eerie::test
