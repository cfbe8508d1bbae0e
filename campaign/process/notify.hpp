#pragma once

#include <string>

namespace eerie::process {

/// Sends the state of this process to systemd: "READY=1", "STATUS=...", "STOPPING=1". Does nothing
/// unless systemd started the process and waits for it (Type=notify). See sd_notify(3).
void notify_service_manager(const std::string& state);

}  // namespace eerie::process
