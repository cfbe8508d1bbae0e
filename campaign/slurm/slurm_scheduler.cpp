#include "campaign/slurm/slurm_scheduler.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "campaign/job_folder/worker_exit.hpp"
#include "campaign/job_folder/worker_lock.hpp"
#include "campaign/manager/waiting/try_later.hpp"
#include "campaign/process/environment.hpp"
#include "campaign/process/signals.hpp"
#include "campaign/slurm/packing.hpp"
#include "solver/base/error.hpp"

namespace eerie::slurm {
namespace fs = std::filesystem;

namespace {

/// As nodes and other managers know it.
std::string key(const job_folder::JobDirectory& directory) {
  return fs::absolute(directory.path).lexically_normal().string();
}

fs::path checked_folder(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  for (const unsigned char c : whole.string())
    if (c == '\\' || c < ' ' || c == 127)
      throw InputError(
          fmt::format("the folder of jobs {}: sbatch cannot take a path with a "
                      "backslash or a control character; give another",
                      whole.string()));
  try {
    static_cast<void>(nlohmann::json(whole.string()).dump());  // as it stands in manifests
  } catch (const nlohmann::json::exception&) {
    throw InputError(
        fmt::format("the folder of jobs {}: its name is not UTF-8; give another", whole.string()));
  }
  return whole;
}

Batch batch_of(const fs::path& jobs_folder, std::span<const std::vector<manager::Task>> packs) {
  Batch batch;
  batch.folder = batches_folder(jobs_folder) / new_batch_id();
  for (const std::vector<manager::Task>& pack : packs) {
    batch.array.emplace_back();
    for (const manager::Task& task : pack)
      batch.array.back().push_back({task.job, job_folder::JobDirectory{key(task.directory)}});
  }
  return batch;
}

manager::WorkerEnd never_started(std::int64_t job) {
  manager::WorkerEnd end;
  end.job = job;
  end.exit_code = job_folder::worker_stopped;
  return end;
}

}  // namespace

SlurmScheduler::SlurmScheduler(SlurmProfile profile, const fs::path& jobs_folder)
    : SlurmScheduler(std::move(profile), jobs_folder, std::make_shared<ChildCommands>(),
                     fs::read_symlink("/proc/self/exe")) {}

SlurmScheduler::SlurmScheduler(SlurmProfile profile, const fs::path& jobs_folder,
                               std::shared_ptr<Commands> commands, fs::path program)
    : profile_(std::move(profile)),
      jobs_folder_(checked_folder(jobs_folder)),
      program_(std::move(program)),
      commands_(std::move(commands)),
      cluster_(profile_, *commands_) {
  if (const auto names = process::environment_for_slurm().left_out; !names.empty())
    spdlog::warn("event=environment message=\"not passed on to Slurm and workers: {}\"",
                 fmt::join(names, " "));
  adopt_batches();
}

void SlurmScheduler::adopt_batches() {
  std::error_code none;
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(batches_folder(jobs_folder_), none))
    folders.push_back(entry.path());
  std::ranges::sort(folders);
  for (const fs::path& folder : folders) {
    if (auto batch = read_batch(folder)) {
      live_.emplace_back(std::move(*batch), false, grace());
      hold(live_.back());
    } else if (!fs::exists(folder / "manifest.json")) {
      fs::remove_all(folder, none);  // the rest of one that was being made or removed
    } else {
      throw EnvironmentError(
          fmt::format("{}: its manifest.json cannot be read, or is of another version of eerie, so "
                      "its jobs might be submitted twice; cancel the job eerie-{} and remove the "
                      "folder",
                      folder.string(), folder.filename().string()));
    }
  }
}

void SlurmScheduler::hold(const LiveBatch& batch) {
  for (const LiveBatch::ArrayTask& task : batch.array())
    for (const LiveBatch::Job& job : task.jobs)
      if (!job.over) ++held_[job.place.directory.path.string()];
}

std::size_t SlurmScheduler::free_slots() {
  refresh();
  const auto room = static_cast<std::size_t>(profile_.max_queued);
  std::size_t queued = 0;
  for (const LiveBatch& batch : live_) {
    if (!batch.batch().slurm_id) return 0;  // first it must be known what became of it
    queued += batch.array_tasks_left();
  }
  const std::size_t free = room - std::min(room, queued);
  const bool trickle = queued > 0 && 4 * free < room;
  if (trickle || Clock::now() < refused_until_) return 0;
  return std::min(free, largest_array());
}

std::vector<std::string> SlurmScheduler::start(std::span<const manager::Task> tasks) {
  const std::vector<std::vector<manager::Task>> packs = packed(tasks, pack_core_seconds(profile_));
  std::unordered_map<std::int64_t, std::string> names;
  const std::size_t most = largest_array();
  for (std::size_t first = 0; first < packs.size(); first += most) {
    const auto chunk = std::span(packs).subspan(first, std::min(most, packs.size() - first));
    const std::vector<std::string> chunk_names = submit(chunk, first == 0);
    for (std::size_t k = 0; k < chunk.size(); ++k)
      for (const manager::Task& task : chunk[k]) names[task.job] = chunk_names[k];
  }
  std::vector<std::string> in_order;
  for (const manager::Task& task : tasks) in_order.push_back(names.at(task.job));
  return in_order;
}

std::vector<std::string> SlurmScheduler::submit(std::span<const std::vector<manager::Task>> packs,
                                                bool first) {
  Batch batch = batch_of(jobs_folder_, packs);
  install_batch(batch, program_);
  const Submission submission = cluster_.submit(batch);
  const bool is_accepted = submission.kind == Submission::Kind::accepted;
  const bool is_refused = submission.kind == Submission::Kind::refused;
  if (is_refused) {
    remove_batch(batch);
    refused(packs.size());
  } else {
    live_.emplace_back(std::move(batch), is_accepted || !first, grace());
    hold(live_.back());
  }
  if (is_accepted) {
    live_.back().note_slurm_id(submission.id);
    accepted();
  }
  if (first && is_refused)
    throw manager::TryLater(fmt::format("{}; tried again after {} s with {} array tasks at most",
                                        submission.reason, patience_.count(), array_limit_),
                            patience_);
  if (first && !is_accepted) throw manager::TryLater(submission.reason, grace());
  // What was submitted before stays so; these come back as stopped before they began.
  if (is_refused)
    for (const std::vector<manager::Task>& pack : packs)
      for (const manager::Task& task : pack) ended_.push_back(never_started(task.job));
  std::vector<std::string> names;
  for (std::size_t k = 0; k < packs.size(); ++k)
    names.push_back(is_accepted ? fmt::format("slurm {}_{}", submission.id.number, k) : "slurm");
  return names;
}

/// A limit on the jobs of a user or an account ends with time, or never where one submission is
/// above it: so later and less.
void SlurmScheduler::refused(std::size_t array_tasks) {
  constexpr std::chrono::seconds first{10}, longest{600};
  patience_ = std::clamp(2 * patience_, first, longest);
  refused_until_ = Clock::now() + patience_;
  array_limit_ = std::max<std::size_t>(1, array_tasks / 2);
}

void SlurmScheduler::accepted() {
  patience_ = std::chrono::seconds(0);
  array_limit_ *= 2;
  if (array_limit_ >= cluster_.array_size()) array_limit_ = 0;
}

std::size_t SlurmScheduler::largest_array() {
  return array_limit_ > 0 ? std::min(array_limit_, cluster_.array_size()) : cluster_.array_size();
}

bool SlurmScheduler::holds(const manager::Task& task) {
  refresh();
  return held_.contains(key(task.directory)) || job_folder::WorkerLock::held(task.directory);
}

std::vector<manager::WorkerEnd> SlurmScheduler::wait(std::chrono::milliseconds longest) {
  refresh();
  if (ended_.empty() && longest.count() > 0) {
    process::wait_for_signal(longest);
    refresh();
  }
  return std::exchange(ended_, {});
}

void SlurmScheduler::refresh() {
  if (live_.empty() || Clock::now() < next_poll_) return;
  const Answers answers = ask_queues();
  for (LiveBatch& batch : live_)
    if (const auto& queue = answers.at(batch.batch().cluster())) show_queue(batch, *queue);
  forget_what_is_over(answers);
  send_cancellations();
  // Counted from the end: a controller that takes long to answer is not asked without a pause.
  next_poll_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                  std::chrono::duration<double>(profile_.poll_interval_s));
}

SlurmScheduler::Answers SlurmScheduler::ask_queues() {
  std::map<std::string, std::vector<std::string>> names;
  for (const LiveBatch& batch : live_)
    names[batch.batch().cluster()].push_back(batch.batch().name());
  Answers answers;
  bool silent = false;
  for (const auto& [cluster, of_cluster] : names) {
    answers[cluster] = cluster_.queue(of_cluster, cluster);
    silent |= !answers[cluster].has_value();
  }
  note_silence(silent);
  return answers;
}

void SlurmScheduler::note_silence(bool silent) {
  if (silent == squeue_is_silent_) return;
  squeue_is_silent_ = silent;
  if (silent)
    spdlog::warn(
        "event=squeue-silent batches={} message=\"jobs go on; nothing is concluded but from their "
        "files\"",
        live_.size());
  else
    spdlog::info("event=squeue-answers");
}

void SlurmScheduler::show_queue(LiveBatch& batch, const Queue& queue) {
  const auto found = std::ranges::find_if(
      queue, [&](const auto& entry) { return entry.second.name == batch.batch().name(); });
  if (found == queue.end()) return batch.see(nullptr);
  if (!batch.batch().slurm_id) batch.note_slurm_id({found->first, ""});
  batch.see(&found->second);
}

void SlurmScheduler::forget_what_is_over(const Answers& answers) {
  for (auto batch = live_.begin(); batch != live_.end();) {
    release(*batch, batch->newly_over(answers.at(batch->batch().cluster()).has_value()));
    if (batch->over()) {
      remove_batch(batch->batch());
      batch = live_.erase(batch);
    } else {
      ++batch;
    }
  }
}

void SlurmScheduler::release(const LiveBatch& batch, const std::vector<manager::WorkerEnd>& ends) {
  if (ends.empty()) return;
  std::unordered_set<std::int64_t> jobs;
  for (const manager::WorkerEnd& end : ends) jobs.insert(end.job);
  for (const LiveBatch::ArrayTask& task : batch.array())
    for (const LiveBatch::Job& job : task.jobs) {
      if (!jobs.contains(job.place.job)) continue;
      const auto entry = held_.find(job.place.directory.path.string());
      if (entry != held_.end() && --entry->second == 0) held_.erase(entry);
    }
  if (batch.started_here()) ended_.insert(ended_.end(), ends.begin(), ends.end());
}

void SlurmScheduler::stop(std::span<const manager::Task> tasks, manager::StopKind kind) {
  std::unordered_set<std::string> directories;
  for (const manager::Task& task : tasks) directories.insert(key(task.directory));
  for (LiveBatch& batch : live_) batch.stop(directories, kind);
  send_cancellations();
}

void SlurmScheduler::send_cancellations() {
  for (LiveBatch& batch : live_) {
    if (!batch.batch().slurm_id) continue;
    for (const manager::StopKind kind :
         {manager::StopKind::with_checkpoint, manager::StopKind::at_once}) {
      const std::vector<int> indices = batch.to_cancel(kind);
      if (indices.empty()) continue;
      if (cluster_.cancel(*batch.batch().slurm_id, indices,
                          kind == manager::StopKind::with_checkpoint))
        batch.cancelled(indices);
    }
  }
}

}  // namespace eerie::slurm
