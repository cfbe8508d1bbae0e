#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace eerie::slurm {

/// The end of a program, with its output.
struct CommandEnd {
  int exit_code = -1;      ///< -1 where it did not end by itself
  bool timed_out = false;  ///< it was killed, and what it has done is not known
  std::string out, err;

  bool ok() const { return exit_code == 0; }
  /// The end of its output, for people.
  std::string complaint() const;
};

/// Runs the programs of Slurm; tests replace it.
class Commands {
 public:
  virtual ~Commands() = default;

  /// Runs words[0], found in PATH, without a shell. A program that cannot be started gives a
  /// CommandEnd, too, with the reason in `err`.
  virtual CommandEnd run(const std::vector<std::string>& words,
                         std::chrono::milliseconds limit) = 0;
};

/// Runs programs as child processes.
class ChildCommands : public Commands {
 public:
  CommandEnd run(const std::vector<std::string>& words, std::chrono::milliseconds limit) override;
};

}  // namespace eerie::slurm
