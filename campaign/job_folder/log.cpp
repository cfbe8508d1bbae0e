#include "campaign/job_folder/log.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include "solver/base/error.hpp"

namespace eerie::job_folder {

void open_log(const JobDirectory& directory) {
  try {
    auto log = spdlog::basic_logger_mt("eerie", directory.log().string());
    log->set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
    log->flush_on(spdlog::level::info);
    spdlog::set_default_logger(std::move(log));
  } catch (const spdlog::spdlog_ex& error) {
    throw EnvironmentError(error.what());
  }
}

}  // namespace eerie::job_folder
