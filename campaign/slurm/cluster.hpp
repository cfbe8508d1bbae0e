#pragma once

#include <span>

#include "campaign/slurm/batch.hpp"
#include "campaign/slurm/commands.hpp"
#include "campaign/slurm/profile.hpp"
#include "campaign/slurm/queue_text.hpp"

namespace eerie::slurm {

/// The command line of sbatch for a batch.
std::vector<std::string> sbatch_words(const SlurmProfile& profile, const Batch& batch);

/// The outcome of a submission.
struct Submission {
  enum class Kind {
    accepted,
    refused,  ///< it is certainly not in the queue
    unknown,  ///< it may be in the queue; only squeue can say that later
  };
  Kind kind = Kind::refused;
  std::int64_t id = 0;
  std::string reason = {};  ///< exists where it was not accepted
};

/// The needed parts of Slurm: sbatch, squeue, scancel and scontrol, without accounting.
class Cluster {
 public:
  Cluster(SlurmProfile profile, Commands& commands);

  /// Submits a batch. sbatch may fail after Slurm has taken the job, so a failed submission is
  /// looked up by its name.
  Submission submit(const Batch& batch);

  /// The array jobs of these names in the queue. Nothing where squeue does not answer, which says
  /// nothing about the jobs.
  std::optional<Queue> queue(const std::vector<std::string>& names);

  /// Cancels these array tasks, or with `pending_only` those that have not started. Returns false
  /// where Slurm did not accept it.
  bool cancel(std::int64_t id, const std::vector<int>& indices, bool pending_only);

  /// The most array tasks of one job.
  std::size_t array_size();

 private:
  SlurmProfile profile_;
  Commands& commands_;
  std::optional<std::size_t> array_size_;
};

}  // namespace eerie::slurm
