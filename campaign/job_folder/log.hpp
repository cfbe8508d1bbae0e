#pragma once

#include <spdlog/formatter.h>

#include <memory>

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::job_folder {

/// The format of a line in a log: time, level and message. Messages are made plain
/// (campaign/text/plain_text.hpp), so that text from files and programs can neither begin a line
/// nor control a terminal.
std::unique_ptr<spdlog::formatter> log_formatter();

/// Appends the messages of spdlog to the log.txt of the directory.
void open_log(const JobDirectory& directory);

/// Sends the messages of a campaign's manager to "<database>.log", three files of 10 MB in turn,
/// and those of `level` and above to standard error.
void open_campaign_log(const std::filesystem::path& database, spdlog::level::level_enum level);

}  // namespace eerie::job_folder
