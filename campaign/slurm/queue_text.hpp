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

/// What squeue says of one array job.
struct QueuedArray {
  std::string name;
  std::map<int, std::string> states = {};  ///< index -> Slurm's word, known or not
  bool more = false;  ///< a line could not be read to its end: any index may be in the queue

  bool contains(int index) const { return more || states.contains(index); }
};

/// Array jobs by their id.
using Queue = std::map<std::int64_t, QueuedArray>;

/// squeue's option -o, and the reading of it: "17_4|RUNNING|eerie-..." or, where squeue does not
/// expand an array, "17_[5-9,12%2]|PENDING|eerie-...". No word for a state is an error: whatever
/// stands in the queue is still there.
inline constexpr const char* queue_format = "%i|%T|%j";
Queue parse_queue(std::string_view text);

/// {3, 4, 5, 9} -> "3-5,9", as sbatch and scancel take indices.
std::string index_ranges(const std::vector<int>& sorted);

/// MaxArraySize in what `scontrol show config` prints.
std::optional<int> max_array_size(std::string_view config);

}  // namespace eerie::slurm
