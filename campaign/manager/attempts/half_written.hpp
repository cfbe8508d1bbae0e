#pragma once

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::manager {

/// Removes temporary files of a manager or worker that was killed while it wrote.
void remove_half_written(const job_folder::JobDirectory& directory);

}  // namespace eerie::manager
