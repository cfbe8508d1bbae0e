#pragma once

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::manager {

/// Removes what a manager or a worker left that was killed while it wrote.
void remove_half_written(const job_folder::JobDirectory& directory);

}  // namespace eerie::manager
