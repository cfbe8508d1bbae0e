#include "campaign/manager/attempts/half_written.hpp"

#include <spdlog/spdlog.h>

#include <filesystem>

#include "campaign/job_folder/worker_lock.hpp"
#include "solver/base/file.hpp"

namespace eerie::manager {

void remove_half_written(const job_folder::JobDirectory& directory) {
  if (job_folder::WorkerLock::held(directory)) return;  // they may be of a writer at work
  for (const std::filesystem::path& half : half_written_files(directory.path)) {
    std::error_code error;
    if (std::filesystem::remove(half, error); error)  // no reason to stop a campaign
      spdlog::warn("event=litter file=\"{}\" reason=\"{}\"", half.string(), error.message());
  }
}

}  // namespace eerie::manager
