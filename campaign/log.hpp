#pragma once

#include "campaign/job_directory.hpp"

namespace eerie {

/// Sends spdlog's messages to the directory's log.txt, behind what stands there.
void open_log(const JobDirectory& directory);

}  // namespace eerie
