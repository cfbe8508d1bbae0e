#include "campaign/manager/attempts/attempt_verdict.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <cstring>

#include "campaign/job_folder/worker_exit.hpp"
#include "db/jobs/jobs.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::manager {
namespace fs = std::filesystem;

namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

std::string last_line(const fs::path& log) {
  std::error_code ignored;
  if (!fs::exists(log, ignored)) return "";
  std::string text = read_file(log);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t start = text.rfind('\n');
  return start == std::string::npos ? text : text.substr(start + 1);
}

Crashed crash(const job_folder::JobDirectory& directory, const WorkerEnd& end) {
  if (end.signal != 0)
    return {fmt::format("signal {}", end.signal),
            fmt::format("the worker was ended by signal {} ({}); see {}", end.signal,
                        ::strsignal(end.signal), directory.log().string())};
  return {fmt::format("exit {}", end.exit_code),
          fmt::format("the worker ended with code {}; the last line of {}: {}", end.exit_code,
                      directory.log().string(), last_line(directory.log()))};
}

std::optional<WorkerEnd> own_word(const job_folder::JobDirectory& directory) {
  const auto ended = job_folder::read_ended(directory);
  if (!ended) return std::nullopt;
  WorkerEnd end;
  // As shells do, 128 + N says that signal N ended it.
  if (ended->exit_code > 128)
    end.signal = ended->exit_code - 128;
  else
    end.exit_code = ended->exit_code;
  return end;
}

/// Whether a worker got as far as its first heartbeat.
bool at_work(const job_folder::JobDirectory& directory) {
  std::error_code ignored;
  return fs::exists(directory.heartbeat(), ignored);
}

/// A result.json that is there and is no result must not be taken for one, nor be lost.
void set_aside_bad_result(const job_folder::JobDirectory& directory) {
  std::error_code ignored;
  if (fs::exists(directory.result(), ignored))
    fs::rename(directory.result(), directory.path / "result.json.unreadable", ignored);
}

}  // namespace

AttemptVerdict judge_attempt(const job_folder::JobDirectory& directory, const std::string& hash,
                             const std::optional<WorkerEnd>& seen) {
  if (auto stored = job_folder::read_result(directory, hash)) return HasResult{std::move(*stored)};
  set_aside_bad_result(directory);
  if (auto failure = job_folder::read_failure(directory)) return Failed{std::move(*failure)};
  const std::optional<WorkerEnd> end = seen && !seen->lost ? seen : own_word(directory);
  if (!end && seen && at_work(directory))
    return Crashed{"lost", fmt::format("the worker vanished without a word; see {}",
                                       directory.log().string())};
  if (!end || end->exit_code == job_folder::worker_busy) return Lost{};
  if (end->exit_code == job_folder::worker_disk_full) return DiskFull{};
  // A worker that is told to stop in its first moments has no handler yet and dies of the signal.
  if (end->exit_code == job_folder::worker_stopped || end->signal == SIGTERM ||
      end->signal == SIGINT)
    return Stopped{};
  return crash(directory, *end);
}

db::JobState commit(db::Connection& connection, const db::Job& job, const AttemptVerdict& verdict,
                    const Attempt& attempt) {
  db::AttemptEnd row;
  row.particle_steps = attempt.particle_steps;
  row.wall_s = attempt.wall_s;
  if (attempt.word) {
    row.host = attempt.word->host;
    if (attempt.word->pid > 0) row.pid = attempt.word->pid;
    if (attempt.word->core_seconds > 0) row.core_seconds = attempt.word->core_seconds;
    if (attempt.word->peak_memory_bytes > 0)
      row.peak_memory_bytes = attempt.word->peak_memory_bytes;
  }
  if (attempt.end && attempt.end->core_seconds) row.core_seconds = attempt.end->core_seconds;
  if (attempt.end && attempt.end->peak_memory_bytes)
    row.peak_memory_bytes = attempt.end->peak_memory_bytes;
  const auto end_as = [&](db::ExitReason reason, std::string kind, std::string message,
                          db::JobState next) {
    row.reason = reason;
    row.failure_kind = std::move(kind);
    row.message = std::move(message);
    return db::end_attempt(connection, job.id, row, next);
  };
  const auto over_limit = [&] {
    return end_as(
        db::ExitReason::failed, "wall-limit",
        fmt::format("it took longer than its wall limit of {0:g} s; raise that with "
                    "`eerie wall-limit none {1} --db {2}`, and `eerie retry {1} --db {2}` "
                    "lets it go on from its checkpoint",
                    job.wall_limit_s.value_or(0), job.hash.substr(0, 16),
                    shell_word(connection.path().string())),
        db::JobState::failed);
  };
  return std::visit(
      Overloaded{
          [&](const HasResult& v) {
            row.reason = db::ExitReason::finished;
            row.particle_steps = v.stored.result.particle_steps;
            db::finish(connection, job.id, row, v.stored.result, v.stored.remnants);
            return db::JobState::done;
          },
          [&](const Failed& v) {
            return end_as(db::ExitReason::failed, v.failure.kind,
                          fmt::format("step {}: {}", v.failure.step, v.failure.message),
                          db::JobState::failed);
          },
          [&](const Stopped&) {
            if (attempt.over_wall_limit) return over_limit();
            return end_as(db::ExitReason::stopped, "", "", db::JobState::pending);
          },
          [&](const Crashed& v) {
            if (attempt.over_wall_limit) return over_limit();
            const bool last = job.crashes + 1 >= max_crashes;
            return end_as(db::ExitReason::crashed, v.kind, v.message,
                          last ? db::JobState::failed : db::JobState::pending);
          },
          [&](const DiskFull&) {
            return end_as(db::ExitReason::stopped, "disk-full", "", db::JobState::pending);
          },
          [&](const Lost&) { return end_as(db::ExitReason::lost, "", "", db::JobState::pending); },
      },
      verdict);
}

}  // namespace eerie::manager
