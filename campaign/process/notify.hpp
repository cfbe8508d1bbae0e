#pragma once

#include <string>

namespace eerie::process {

/// Tells systemd, where it started this process and waits for it (Type=notify), how things are:
/// "READY=1", "STATUS=...", "STOPPING=1". Does nothing otherwise. See sd_notify(3).
void notify_service_manager(const std::string& state);

}  // namespace eerie::process
