#pragma once

namespace eerie::job_folder {

// Exit codes of a worker that are no verdict on its job; others are those of every command.

/// It was told to stop and left a checkpoint (sysexits' EX_TEMPFAIL).
inline constexpr int worker_stopped = 75;
/// It could not write for want of room on the disk (EX_IOERR).
inline constexpr int worker_disk_full = 74;
/// Another worker is in the directory (EX_CANTCREAT).
inline constexpr int worker_busy = 73;

}  // namespace eerie::job_folder
