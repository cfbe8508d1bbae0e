#pragma once

namespace eerie::job_folder {

// These exit codes of a worker say nothing about its job. All other codes are those of every
// command.

/// The worker was asked to stop and left a checkpoint (EX_TEMPFAIL of sysexits).
inline constexpr int worker_stopped = 75;
/// The worker could not write, since the disk was full (EX_IOERR).
inline constexpr int worker_disk_full = 74;
/// Another worker works in the directory (EX_CANTCREAT).
inline constexpr int worker_busy = 73;

}  // namespace eerie::job_folder
