#pragma once

#include <chrono>

namespace eerie::process {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGUSR1 request a stop and do not end the process.
/// SIGHUP stays ignored under nohup; SIGUSR1 is the warning of a batch system before its time
/// limit. SIGPIPE is ignored. Call it once, before threads start.
void catch_stop_signals();

/// The number of stop requests since then.
int stop_requests();
/// Whether there was one since stop_requests() was asked last.
bool has_unseen_stop_request();

/// Blocks stop signals and SIGCHLD outside of wait_for_signal(), so that none arrives between a
/// check and the wait that follows it.
void hold_signals();

/// Sleeps until a blocked signal arrives or the time is over.
void wait_for_signal(std::chrono::milliseconds longest);

}  // namespace eerie::process
