#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "campaign/slurm/commands.hpp"

namespace eerie::test {

/// A cluster that does as it is told: takes submissions, lists them, and forgets them.
class FakeSlurm : public slurm::Commands {
 public:
  enum class Sbatch {
    takes,
    refuses,                 ///< a policy of the site
    times_out,               ///< and nothing came of it
    times_out_after_taking,  ///< it had already reached the controller
    complains_after_taking,  ///< "Socket timed out on send/recv operation"
    prints_nothing_we_know,
  };

  slurm::CommandEnd run(const std::vector<std::string>& words, std::chrono::milliseconds) override {
    calls.push_back(words);
    if (words[0] == "sbatch") return sbatch(words);
    if (words[0] == "squeue") return squeue(value(words, "--clusters"));
    if (words[0] == "scancel") return scancel(words);
    return {0, false, "ClusterName             = fake\nMaxArraySize            = 4\n", ""};
  }

  /// Calls of a program so far.
  std::vector<std::vector<std::string>> calls_of(const std::string& program) const {
    std::vector<std::vector<std::string>> found;
    for (const auto& words : calls)
      if (words[0] == program) found.push_back(words);
    return found;
  }
  void set_state(int id, int index, const std::string& state) { jobs[id].states[index] = state; }
  void forget(int id, int index) { jobs[id].states.erase(index); }
  void forget_all() { jobs.clear(); }

  struct Job {
    std::string name;
    std::map<int, std::string> states;
    std::string cluster = {};  ///< it is listed and cancelled there alone; empty: the usual one
  };
  std::map<int, Job> jobs;
  std::vector<std::vector<std::string>> calls;
  Sbatch next_sbatch = Sbatch::takes;
  int refuse_from = 1 << 20;  ///< submissions from this one on are refused
  bool squeue_answers = true, scancel_answers = true;
  bool manifest_came_first = true;
  std::string cluster;     ///< to which sbatch sends jobs
  int answers_before = 0;  ///< answers of squeue before it lists anything
  std::string refusal = "Batch job submission failed: Invalid account";
  int next_id = 1;

 private:
  static std::string value(const std::vector<std::string>& words, const std::string& option) {
    for (const std::string& word : words)
      if (word.starts_with(option + "=")) return word.substr(option.size() + 1);
    return "";
  }

  slurm::CommandEnd sbatch(const std::vector<std::string>& words) {
    const std::filesystem::path script = words.back();
    manifest_came_first &= std::filesystem::exists(script) &&
                           std::filesystem::exists(script.parent_path() / "manifest.json");
    if (next_sbatch == Sbatch::refuses || next_id >= refuse_from)
      return {1, false, "", "sbatch: error: " + refusal + "\n"};
    if (next_sbatch == Sbatch::times_out) return {-1, true, "", ""};
    const int id = next_id++;
    jobs[id].name = value(words, "--job-name");
    jobs[id].cluster = cluster;
    const int last = std::stoi(value(words, "--array").substr(2));
    for (int k = 0; k <= last; ++k) jobs[id].states[k] = "PENDING";
    if (next_sbatch == Sbatch::times_out_after_taking) return {-1, true, "", ""};
    if (next_sbatch == Sbatch::complains_after_taking)
      return {1, false, "", "sbatch: error: Socket timed out on send/recv operation\n"};
    if (next_sbatch == Sbatch::prints_nothing_we_know) return {0, false, "Bonjour\n", ""};
    return {0, false, fmt::format("{}{}\n", id, cluster.empty() ? "" : ";" + cluster), ""};
  }

  slurm::CommandEnd squeue(const std::string& asked) {
    if (!squeue_answers)
      return {1, false, "", "slurm_load_jobs error: Unable to contact slurm controller\n"};
    std::string out;
    if (answers_before-- > 0) return {0, false, out, ""};
    for (const auto& [id, job] : jobs)
      for (const auto& [index, state] : job.states)
        if (job.cluster == asked) out += fmt::format("{}_{}|{}|{}\n", id, index, state, job.name);
    return {0, false, out, ""};
  }

  slurm::CommandEnd scancel(const std::vector<std::string>& words) {
    if (!scancel_answers) return {1, false, "", "scancel: error: no\n"};
    const bool pending_only = words[1] == "--state=PENDING";
    const int id = std::stoi(words.back());
    if (jobs[id].cluster != value(words, "--clusters")) return {1, false, "", "Invalid job id\n"};
    std::erase_if(jobs[id].states, [&](const auto& entry) {
      return !pending_only || entry.second == "PENDING";  // the tests cancel whole arrays
    });
    return {0, false, "", ""};
  }
};

}  // namespace eerie::test
