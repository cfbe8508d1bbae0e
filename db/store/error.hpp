#pragma once

#include <stdexcept>

namespace eerie::db {

/// The database cannot be used: it is missing, foreign, too new, full or on the wrong disk. The
/// text names the file, the reason and the mend.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The call did nothing, and it may succeed later.
struct TemporaryError : Error {
  using Error::Error;
};

/// The disk is full.
struct FullError : TemporaryError {
  using TemporaryError::TemporaryError;
};

/// Another program is writing to the database.
struct BusyError : TemporaryError {
  using TemporaryError::TemporaryError;
};

/// The file that was opened no longer has its name: it was removed, or another file has replaced
/// it. Anything written would be lost.
struct GoneError : Error {
  using Error::Error;
};

/// Another manager holds the database. The text says which one.
struct LockedError : Error {
  using Error::Error;
};

}  // namespace eerie::db
