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
  SlurmJobId id = {};
  std::string reason = {};  ///< where it was not accepted
};

/// The needed parts of Slurm: sbatch, squeue, scancel and scontrol, without accounting.
class Cluster {
 public:
  Cluster(SlurmProfile profile, Commands& commands);

  /// sbatch may fail after its job was taken, so a failed one is looked up by its name. Refused is
  /// only what Slurm turned down in words that we know: squeue may list a job late.
  Submission submit(const Batch& batch);

  /// The array jobs of these names in the queue of a cluster (empty: the one asked by default);
  /// nothing where squeue does not answer, which says nothing about the jobs.
  std::optional<Queue> queue(const std::vector<std::string>& names,
                             const std::string& cluster = "");

  /// Cancels these array tasks; where `pending_only`, those that have not started. False where
  /// Slurm did not take it.
  bool cancel(const SlurmJobId& id, const std::vector<int>& indices, bool pending_only);

  /// The most array tasks of one job.
  std::size_t array_size();

 private:
  SlurmProfile profile_;
  Commands& commands_;
  std::optional<std::size_t> array_size_;
};

}  // namespace eerie::slurm
