#pragma once

#include "campaign/job_folder/job_directory.hpp"

namespace eerie::merging {

/// How a job directory comes into another job folder.
enum class Transfer { link, copy };

/// Makes the directory `to` by a link to `from`, or by a copy of its files. What lies there already
/// is kept under its name and ".before-merge". Returns false where `from` is not there. Does
/// nothing where both are one folder. Throws EnvironmentError.
bool transfer(const job_folder::JobDirectory& from, const job_folder::JobDirectory& to,
              Transfer how);

}  // namespace eerie::merging
