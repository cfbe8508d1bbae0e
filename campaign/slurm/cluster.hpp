#pragma once

#include <span>

#include "campaign/slurm/batch.hpp"
#include "campaign/slurm/commands.hpp"
#include "campaign/slurm/profile.hpp"
#include "campaign/slurm/queue_text.hpp"

namespace eerie::slurm {

/// sbatch's command line for a batch.
std::vector<std::string> sbatch_words(const SlurmProfile& profile, const Batch& batch);

/// How a submission went.
struct Submission {
  enum class Kind {
    accepted,
    refused,  ///< certainly not in the queue
    unknown,  ///< may be in the queue: only squeue can tell, later
  };
  Kind kind = Kind::refused;
  std::int64_t id = 0;
  std::string reason = {};  ///< where it was not accepted
};

/// Slurm, as much of it as is needed: sbatch, squeue, scancel and scontrol. No accounting.
class Cluster {
 public:
  Cluster(SlurmProfile profile, Commands& commands);

  /// sbatch may fail after its job was taken, so a failed one is looked up by its name.
  Submission submit(const Batch& batch);

  /// The array jobs of these names in the queue; nothing where squeue does not answer, which says
  /// nothing about the jobs.
  std::optional<Queue> queue(const std::vector<std::string>& names);

  /// Cancels these array tasks; where `pending_only`, those that have not started. False where
  /// Slurm did not take it.
  bool cancel(std::int64_t id, const std::vector<int>& indices, bool pending_only);

  /// Array tasks that one job may have.
  std::size_t array_size();

 private:
  SlurmProfile profile_;
  Commands& commands_;
  std::optional<std::size_t> array_size_;
};

}  // namespace eerie::slurm
