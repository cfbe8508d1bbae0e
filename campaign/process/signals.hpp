#pragma once

#include <chrono>

namespace eerie::process {

/// Makes SIGINT, SIGTERM, SIGHUP (unless it is ignored, as under nohup) and SIGUSR1 (a batch
/// system's warning before its time limit) requests to stop instead of ends, and has SIGPIPE
/// ignored. Call once, before threads start.
void catch_stop_signals();

/// How often a stop was asked for since.
int stop_requests();

/// Keeps stop signals and SIGCHLD waiting except inside wait_for_signal(), so that none falls
/// between a check and the wait that follows it.
void hold_signals();

/// Sleeps until a held signal arrives or the time is over.
void wait_for_signal(std::chrono::milliseconds longest);

}  // namespace eerie::process
