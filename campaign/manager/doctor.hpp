#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "db/store/connection.hpp"

namespace eerie::manager {

/// A finding of an examination.
struct Problem {
  std::string what;       ///< one sentence that names the file or the job
  std::string mend;       ///< the remedy, or with `mended` what was done
  bool mendable = false;  ///< whether the program can mend it without a loss of valid data
  bool mended = false;
  bool is_note = false;  ///< whether it is information and no damage
};

/// Reports the progress of an examination: `done` of `total` jobs.
using Examined = std::function<void(std::size_t done, std::size_t total)>;

/// Examines database, job directories and disk.
std::vector<Problem> examine(const db::Connection& connection, const Examined& examined);

/// Mends what is safe to mend, and returns every finding. The caller holds the lock of the
/// database.
std::vector<Problem> mend(db::Connection& connection, const Examined& examined);

}  // namespace eerie::manager
