#include "campaign/cli/output/failures.hpp"

namespace eerie::cli {

void add_failures(Answer& answer, const std::vector<db::FailureGroup>& failures,
                  const job_folder::JobFolder& folder) {
  for (const db::FailureGroup& f : failures)
    answer.say("failed: {} x {}; for example {}: {}\n", f.jobs, f.kind,
               folder.of(f.example_hash).path, f.example_message);
}

}  // namespace eerie::cli
