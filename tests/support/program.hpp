#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace eerie::test {

/// What a run of the program left behind.
struct Ended {
  int code = -1;  ///< exit code; 128 + signal where a signal ended it
  std::string out, err;
};

/// The real program in a folder, started at once. Killed with the object when it still runs.
class Program {
 public:
  Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  pid_t pid() const { return pid_; }
  void send(int signal) const;
  bool running();
  /// What it has written to standard error so far.
  std::string said() const;
  /// And to standard output.
  std::string printed() const;
  /// Waits for the end; fails the test after `deadline`.
  Ended wait(std::chrono::seconds deadline = std::chrono::seconds(120));

 private:
  std::filesystem::path out_, err_;
  pid_t pid_ = 0;
  std::optional<int> status_;
};

/// Program(...).wait().
Ended eerie(const std::filesystem::path& folder, const std::vector<std::string>& arguments);

/// Asks every few milliseconds until `condition` holds; false when the deadline passes first.
bool eventually(const std::function<bool()>& condition,
                std::chrono::seconds deadline = std::chrono::seconds(60));

/// Process id of the live worker of a job directory, once it takes steps.
std::optional<pid_t> worker_at_work(const std::filesystem::path& job_directory);

/// A sweep of small bodies, written to `folder`/sweep.json; the run of each job takes
/// less than a second.
void write_sweep(const std::filesystem::path& folder, double end_time_s, const std::string& grid);

/// The same with short steps: each job takes seconds, for tests that catch it at work.
void write_slow_sweep(const std::filesystem::path& folder, const std::string& grid);

/// Processor time that a process has used, in hundredths of a second.
long processor_ticks(pid_t pid);

/// The job directories in a folder or of a database, in order of their names.
std::vector<std::filesystem::path> job_directories_in(const std::filesystem::path& folder);
std::vector<std::filesystem::path> job_directories(const std::filesystem::path& database);

}  // namespace eerie::test
