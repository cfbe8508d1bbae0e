#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::slurm {

/// A job as sbatch names it.
struct SlurmJobId {
  std::int64_t number = 0;
  std::string cluster = {};  ///< empty: the one that commands ask without being told

  bool operator==(const SlurmJobId&) const = default;
};

/// The job in what `sbatch --parsable` prints, "1234" or "1234;cluster"; nothing where there is
/// none. Lines before the last are a site's greetings.
std::optional<SlurmJobId> submitted_id(std::string_view text);

/// One array job in the output of squeue.
struct QueuedArray {
  std::string name;
  std::map<int, std::string> states = {};  ///< index -> state in Slurm's word, which may be unknown
  bool more = false;  ///< a line was incomplete, so any index may be in the queue

  bool contains(int index) const { return more || states.contains(index); }
};

/// The array jobs by their id.
using Queue = std::map<std::int64_t, QueuedArray>;

/// The option -o of squeue, and the function that reads its output: "17_4|RUNNING|eerie-..." or,
/// where squeue does not expand an array, "17_[5-9,12%2]|PENDING|eerie-...". Every word for a state
/// is accepted, since anything in the queue still exists.
inline constexpr const char* queue_format = "%i|%T|%j";
Queue parse_queue(std::string_view text);

/// Indices in the form of sbatch and scancel: "3-5,9" for {3, 4, 5, 9}.
std::string index_ranges(const std::vector<int>& sorted);

/// MaxArraySize in the output of `scontrol show config`.
std::optional<int> max_array_size(std::string_view config);

}  // namespace eerie::slurm
