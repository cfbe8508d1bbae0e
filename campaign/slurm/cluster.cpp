#include "campaign/slurm/cluster.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_set>

namespace eerie::slurm {
namespace {

// Slurm's own commands give up after MessageTimeout (10 s), some after several tries.
constexpr std::chrono::seconds submission_limit{90}, question_limit{30};

/// Of a word of a command line; with more, all jobs of the user are listed.
constexpr std::size_t most_names = 1000;

/// Slurm's default.
constexpr int usual_array_size = 1001;

/// '%' starts a pattern in names of output files.
std::string output_pattern(const Batch& batch) {
  std::string pattern;
  for (const char c : batch.folder.string()) pattern += c == '%' ? "%%" : std::string(1, c);
  return pattern + "/output_%a.txt";
}

/// Whether these are a controller's or sbatch's words for: no, and it has not been taken. Others
/// ("Socket timed out on send/recv operation") leave open whether it was.
bool turns_down(const std::string& complaint) {
  constexpr std::array<std::string_view, 10> words = {
      "nvalid",   "imit",          "enied",        "ermitted",       "ermission",
      "disabled", "not available", "unrecognized", "not recognized", "cannot start"};
  return std::ranges::any_of(
      words, [&](std::string_view word) { return complaint.find(word) != std::string::npos; });
}

std::string sbatch_time(std::chrono::seconds limit) {
  const long s = limit.count();
  return fmt::format("{}-{:02}:{:02}:{:02}", s / 86400, s / 3600 % 24, s / 60 % 60, s % 60);
}

}  // namespace

std::vector<std::string> sbatch_words(const SlurmProfile& profile, const Batch& batch) {
  std::vector<std::string> words = {
      "sbatch",
      "--parsable",
      fmt::format("--array=0-{}", batch.array.size() - 1),
      "--requeue",
      "--open-mode=append",  // a requeued task must not overwrite what the first one said
      fmt::format("--signal=B:USR1@{}", profile.signal_before_end_s),
      "--job-name=" + batch.name(),
      "--ntasks=1",
      fmt::format("--cpus-per-task={}", profile.cpus_per_task),
      "--output=" + output_pattern(batch),
      "--chdir=" + batch.folder.string()};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.push_back(fmt::format("{}={}", option, value));
  };
  add("--partition", profile.partition);
  add("--account", profile.account);
  add("--qos", profile.qos);
  add("--constraint", profile.constraint);
  add("--mem", profile.memory);
  if (profile.time_limit) add("--time", sbatch_time(*profile.time_limit));
  words.insert(words.end(), profile.extra_sbatch_options.begin(),
               profile.extra_sbatch_options.end());
  words.push_back(batch.script().string());
  return words;
}

Cluster::Cluster(SlurmProfile profile, Commands& commands)
    : profile_(std::move(profile)), commands_(commands) {}

Submission Cluster::submit(const Batch& batch) {
  const CommandEnd end = commands_.run(sbatch_words(profile_, batch), submission_limit);
  if (end.ok())
    if (const auto id = submitted_id(end.out)) return {Submission::Kind::accepted, *id};
  const std::string reason = fmt::format("sbatch: {}", end.complaint());
  const auto found = queue({batch.name()});
  if (found && !found->empty()) return {Submission::Kind::accepted, {found->begin()->first, ""}};
  // One that was killed may still be on its way to the controller.
  const bool refused = found && !end.timed_out && !end.ok() && turns_down(end.complaint());
  return {refused ? Submission::Kind::refused : Submission::Kind::unknown, {}, reason};
}

std::optional<Queue> Cluster::queue(const std::vector<std::string>& names,
                                    const std::string& cluster) {
  std::vector<std::string> words = {"squeue", "--noheader", "--array", "--me",
                                    fmt::format("--format={}", queue_format)};
  if (!cluster.empty()) words.push_back("--clusters=" + cluster);
  if (names.size() <= most_names) words.push_back(fmt::format("--name={}", fmt::join(names, ",")));
  const CommandEnd end = commands_.run(words, question_limit);
  if (!end.ok()) return std::nullopt;
  Queue queue = parse_queue(end.out);
  const std::unordered_set<std::string> ours(names.begin(), names.end());
  std::erase_if(queue, [&](const auto& entry) { return !ours.contains(entry.second.name); });
  return queue;
}

bool Cluster::cancel(const SlurmJobId& id, const std::vector<int>& indices, bool pending_only) {
  std::vector<std::string> words = {"scancel"};
  if (pending_only) words.push_back("--state=PENDING");
  if (!id.cluster.empty()) words.push_back("--clusters=" + id.cluster);
  words.push_back(fmt::format("{}_[{}]", id.number, index_ranges(indices)));
  return commands_.run(words, question_limit).ok();
}

std::size_t Cluster::array_size() {
  if (!array_size_) {
    int size = profile_.max_array_size.value_or(0);
    if (size == 0) {
      const CommandEnd end = commands_.run({"scontrol", "show", "config"}, question_limit);
      size = (end.ok() ? max_array_size(end.out) : std::nullopt).value_or(usual_array_size);
    }
    array_size_ = static_cast<std::size_t>(std::max(1, size));
  }
  return *array_size_;
}

}  // namespace eerie::slurm
