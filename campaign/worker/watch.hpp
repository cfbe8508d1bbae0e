#pragma once

#include <functional>
#include <vector>

#include "analysis/ending/steadiness.hpp"
#include "analysis/remnants/remnants.hpp"
#include "campaign/job_folder/history.hpp"
#include "campaign/job_folder/job_directory.hpp"
#include "campaign/worker/stop_request.hpp"
#include "solver/run/run.hpp"

namespace eerie::worker {

/// Watches the run of one impact: keeps its history and says when it may end, soften or fly.
class Watch {
 public:
  /// Continues the history and the looks that an earlier attempt left in the folder.
  Watch(const Scene& scene, const job_folder::JobDirectory& folder);

  /// The options with which to run the impact. They refer to this object.
  run::RunOptions options(int threads, long max_steps,
                          std::function<void(const run::Progress&)> on_progress);

  const std::vector<job_folder::HistoryRow>& history() const { return history_.rows(); }

 private:
  const remnants::Remnants& found_in(const particles::State& state);
  double flow_speed_in(const io::Snapshot& snapshot);
  run::LookAnswer look(const io::Snapshot& snapshot, const run::LookQuestion& question);
  bool is_unpredictable(const remnants::Remnants& found) const;
  bool is_settled(const io::Snapshot& snapshot, const remnants::Remnants& found) const;
  /// `horizon` is the time ahead for which encounters matter, s.
  particles::Softening softening(const io::Snapshot& snapshot, const remnants::Remnants& found,
                                 double horizon);
  /// Whether the last look would have had another answer if the run might go on for longer.
  bool end_matters(const io::Snapshot& snapshot, const run::LookQuestion& question);

  const Scene& scene_;
  job_folder::JobDirectory folder_;
  StopRequest stop_;
  job_folder::History history_;
  job_folder::RowLog<ending::RemnantLook> looks_;
  remnants::Remnants found_;                    ///< at the last look or row
  double found_at_ = -1;                        ///< simulated time of that, s
  double flow_speed_ = 0, flow_speed_at_ = -1;  ///< the same, m/s and s
};

}  // namespace eerie::worker
