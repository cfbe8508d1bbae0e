#pragma once

#include "campaign/cli/output/answer.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "db/views/query.hpp"

namespace eerie::cli {

/// Adds a line for each group of failures, with an example.
void add_failures(Answer& answer, const std::vector<db::FailureGroup>& failures,
                  const job_folder::JobFolder& folder);

}  // namespace eerie::cli
