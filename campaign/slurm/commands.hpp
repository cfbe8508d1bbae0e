#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace eerie::slurm {

/// What a program left behind.
struct CommandEnd {
  int exit_code = -1;      ///< -1: it never ran to an end of its own
  bool timed_out = false;  ///< it was killed; what it did until then is not known
  std::string out, err;

  bool ok() const { return exit_code == 0; }
  /// Its last words, for people.
  std::string complaint() const;
};

/// The outside world of the Slurm scheduler.
class Commands {
 public:
  virtual ~Commands() = default;

  /// Runs words[0], looked up in PATH, without a shell. A program that cannot be started is a
  /// CommandEnd too, whose `err` says why.
  virtual CommandEnd run(const std::vector<std::string>& words,
                         std::chrono::milliseconds limit) = 0;
};

/// Child processes of this one.
class ChildCommands : public Commands {
 public:
  CommandEnd run(const std::vector<std::string>& words, std::chrono::milliseconds limit) override;
};

}  // namespace eerie::slurm
