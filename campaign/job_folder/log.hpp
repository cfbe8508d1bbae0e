#pragma once

#include <spdlog/formatter.h>

#include <memory>

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::job_folder {

/// Time, level and message of a log's line. Messages are made plain (campaign/text/plain_text.hpp):
/// what they quote from files and programs can neither begin a line of its own nor command a
/// terminal.
std::unique_ptr<spdlog::formatter> log_formatter();

/// Sends spdlog's messages to the directory's log.txt, behind what stands there.
void open_log(const JobDirectory& directory);

}  // namespace eerie::job_folder
