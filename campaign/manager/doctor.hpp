#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "db/store/connection.hpp"

namespace eerie::manager {

/// Something that is not as it should be.
struct Problem {
  std::string what;       ///< one sentence that names the file or the job
  std::string mend;       ///< what helps; or, with `mended`, what was done
  bool mendable = false;  ///< safe to mend by program: nothing that is true is lost
  bool mended = false;
  bool is_note = false;  ///< worth knowing, and no damage
};

/// How far an examination has come: `done` of `total` jobs.
using Examined = std::function<void(std::size_t done, std::size_t total)>;

/// Looks at database, job directories and disk.
std::vector<Problem> examine(const db::Connection& connection, const Examined& examined);

/// Mends what is safe and gives every finding. The caller holds the database's lock.
std::vector<Problem> mend(db::Connection& connection, const Examined& examined);

}  // namespace eerie::manager
