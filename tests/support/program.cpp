#include "tests/support/program.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "solver/base/file.hpp"
#include "tests/support/paths.hpp"

namespace eerie::test {
namespace fs = std::filesystem;

Program::Program(const fs::path& folder, const std::vector<std::string>& arguments) {
  static int number = 0;
  // Outside the folder under test, so that a test may look at everything in it.
  const std::string stem = (fs::temp_directory_path() / ("eerie-e2e-" + std::to_string(::getpid()) +
                                                         "-" + std::to_string(++number)))
                               .string();
  out_ = stem + ".out";
  err_ = stem + ".err";
  std::vector<std::string> words = {"eerie"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  EXPECT_EQ(::posix_spawn(&pid_, program().c_str(), &actions, nullptr, argv.data(), environ), 0);
  posix_spawn_file_actions_destroy(&actions);
}

Program::~Program() {
  if (running()) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  std::error_code ignored;
  fs::remove(out_, ignored);
  fs::remove(err_, ignored);
}

void Program::send(int signal) const { ::kill(pid_, signal); }

bool Program::running() {
  int status = 0;
  if (!status_ && ::waitpid(pid_, &status, WNOHANG) == pid_) status_ = status;
  return !status_;
}

std::string Program::said() const { return read_file(err_); }
std::string Program::printed() const { return read_file(out_); }

Ended Program::wait(std::chrono::seconds deadline) {
  if (!eventually([this] { return !running(); }, deadline)) {
    ADD_FAILURE() << "the program still runs after " << deadline.count() << " s";
    return {};
  }
  const int code = WIFEXITED(*status_) ? WEXITSTATUS(*status_) : 128 + WTERMSIG(*status_);
  return {code, read_file(out_), read_file(err_)};
}

Ended eerie(const fs::path& folder, const std::vector<std::string>& arguments) {
  return Program(folder, arguments).wait();
}

bool eventually(const std::function<bool()>& condition, std::chrono::seconds deadline) {
  const auto end = std::chrono::steady_clock::now() + deadline;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // between two questions only
  }
  return true;
}

std::optional<pid_t> worker_at_work(const fs::path& path) {
  const job_folder::JobDirectory directory{path};
  const auto progress = job_folder::read_progress(directory);
  if (!progress || progress->step == 0 || !job_folder::WorkerLock::held(directory))
    return std::nullopt;
  const auto pid = static_cast<pid_t>(progress->pid);
  // The file may be that of an earlier worker of the job.
  return ::kill(pid, 0) == 0 ? std::optional(pid) : std::nullopt;
}

namespace {

void write_sweep(const fs::path& folder, double end_time_s, const std::string& grid,
                 const nlohmann::json& numerics) {
  using nlohmann::json;
  const json scene = {{"numerics", numerics},
                      {"output", {{"history_interval_s", 100}, {"checkpoint_interval_s", 0.03}}},
                      {"end", {{"time_s", end_time_s}}}};
  const json sweep = {{"name", "small"}, {"scene", scene}, {"grid", json::parse(grid)}};
  install_text(folder / "sweep.json", sweep.dump());
}

}  // namespace

void write_sweep(const fs::path& folder, double end_time_s, const std::string& grid) {
  write_sweep(folder, end_time_s, grid, {{"particles_per_target", 100}});
}

void write_slow_sweep(const fs::path& folder, const std::string& grid) {
  write_sweep(folder, 40000, grid, {{"particles_per_target", 100}, {"flow_mach", 0}, {"cfl", 0.1}});
}

long processor_ticks(pid_t pid) {
  // Fields 14 and 15: in user mode and in the kernel.
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  std::string word;
  long sum = 0;
  for (int field = 1; field <= 15 && stat >> word; ++field)
    if (field >= 14) sum += std::stol(word);
  return sum;
}

std::vector<fs::path> job_directories_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const fs::path name = entry.path().filename();
    if (entry.is_directory() && name != "batches" && name != "bodies")
      found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<fs::path> job_directories(const fs::path& database) {
  return job_directories_in(database.string() + ".jobs");
}

}  // namespace eerie::test
