#pragma once

#include <stdexcept>

namespace eerie::db {

/// The database cannot be used: missing, foreign, too new, full, on the wrong disk. The text
/// names the file, the reason and the mend.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The disk is full: nothing was written, and the same call may succeed later.
struct FullError : Error {
  using Error::Error;
};

/// Another manager holds the database; the text says which.
struct LockedError : Error {
  using Error::Error;
};

}  // namespace eerie::db
