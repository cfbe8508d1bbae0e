#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/slurm/commands.hpp"
#include "campaign/slurm/queue_text.hpp"
#include "tests/io/snapshot_fixture.hpp"

namespace eerie::test {

/// A cluster of two nodes with a core each, n1 and n2, all on this machine: its own munged,
/// slurmctld and slurmds on free ports, as the user that runs the test. While it lives, SLURM_CONF
/// names it. All its processes end with it.
class RealSlurm {
 public:
  RealSlurm();
  ~RealSlurm();
  RealSlurm(const RealSlurm&) = delete;
  RealSlurm& operator=(const RealSlurm&) = delete;

  /// Why this machine cannot run one; empty where it can.
  static std::string missing();

  /// Both nodes answer. Fails the test and says what the daemons logged where they do not.
  bool ready();

  /// A node fails: its array tasks go back to the queue. And comes back.
  void fail(const std::string& node);
  void resume(const std::string& node);

  /// Requeued array tasks wait for two minutes; this spares them that. Returns how many waited.
  int start_requeued();

  /// Lines "<id>|<state>|<name>" of array tasks on a node, or of all.
  std::string queue(const std::string& node = "");

 private:
  slurm::CommandEnd call(const std::vector<std::string>& words);
  std::string logs() const;

  TemporaryFolder folder_;
  slurm::ChildCommands commands_;
};

}  // namespace eerie::test
