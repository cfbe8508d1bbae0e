#pragma once

#include <stdexcept>
#include <string>

namespace eerie {

/// Exit codes of the program; every typed error maps to one of them.
enum class ExitCode : int { done = 0, job_failed = 1, bad_input = 2, environment = 3 };

/// The user's input cannot be used (exit 2). The text names field, value, allowed range and mend.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Something outside the program is missing or broken: disk, permission, tool (exit 3).
struct EnvironmentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A disk is full. The same work may succeed later.
struct DiskFullError : EnvironmentError {
  using EnvironmentError::EnvironmentError;
};

/// The computation itself went wrong: a NaN, a negative density, a lost particle (exit 1).
struct NumericalError : std::runtime_error {
  NumericalError(std::string kind_, long step_, long particle_id_, const std::string& text)
      : std::runtime_error(text), kind(std::move(kind_)), step(step_), particle_id(particle_id_) {}
  std::string kind;  ///< e.g. "not-finite", "negative-density"
  long step;
  long particle_id;  ///< -1 where no single particle caused it
};

}  // namespace eerie
