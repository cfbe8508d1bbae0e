#pragma once

#include <stdexcept>

namespace eerie::db {

/// The database cannot be used: missing, foreign, too new, full, on the wrong disk. The text
/// names the file, the reason and the mend.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Nothing was written or read now, and the same call may succeed later.
struct TemporaryError : Error {
  using Error::Error;
};

/// The disk is full.
struct FullError : TemporaryError {
  using TemporaryError::TemporaryError;
};

/// Another program holds the database open for writing.
struct BusyError : TemporaryError {
  using TemporaryError::TemporaryError;
};

/// The file that was opened is no longer there under its name: removed, or another put in its
/// place. What is written would be lost.
struct GoneError : Error {
  using Error::Error;
};

/// Another manager holds the database; the text says which.
struct LockedError : Error {
  using Error::Error;
};

}  // namespace eerie::db
