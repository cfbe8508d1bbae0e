#pragma once

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::job_folder {

/// Sends spdlog's messages to the directory's log.txt, behind what stands there.
void open_log(const JobDirectory& directory);

}  // namespace eerie::job_folder
