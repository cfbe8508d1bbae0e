#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "db/store/connection.hpp"

namespace eerie::job_folder {

/// The folder through which manager and worker speak (docs/reference/files.md). Every file
/// in it is installed whole or not at all.
struct JobDirectory {
  std::filesystem::path path;

  std::filesystem::path scene() const { return path / "scene.json"; }
  std::filesystem::path progress() const { return path / "progress.json"; }
  std::filesystem::path heartbeat() const { return path / "heartbeat.json"; }
  std::filesystem::path result() const { return path / "result.json"; }
  std::filesystem::path failure() const { return path / "failure.json"; }
  std::filesystem::path history() const { return path / "history.csv"; }
  std::filesystem::path remnants() const { return path / "remnants.csv"; }
  std::filesystem::path first_snapshot() const { return path / "snapshot_0000.hdf5"; }
  std::filesystem::path final_snapshot() const { return path / "final.hdf5"; }
  std::filesystem::path checkpoint() const { return path / "checkpoint.hdf5"; }
  std::filesystem::path previous_checkpoint() const { return path / "checkpoint_previous.hdf5"; }
  std::filesystem::path log() const { return path / "log.txt"; }
  std::filesystem::path worker_lock() const { return path / "worker.lock"; }
  std::filesystem::path ended() const { return path / "ended.json"; }
  std::filesystem::path stop() const { return path / "stop"; }
};

/// Where the job directories of a campaign lie.
struct JobFolder {
  std::filesystem::path root;
  /// root / first 16 hex digits of the hash.
  JobDirectory of(const std::string& hash) const { return {root / hash.substr(0, 16)}; }
};

/// The folder that the database names, or "<database>.jobs".
JobFolder job_folder(const db::Connection& connection);

/// Makes the folder and tries to write in it. Throws EnvironmentError that says why it cannot be
/// used; DiskFullError where it has no room.
void require_usable(const std::filesystem::path& root);

/// Makes the directory and sees that what manager and worker open in it are files. Throws
/// EnvironmentError that names what is in the way.
void require_usable(const JobDirectory& directory);

/// Lets the job directories of a database lie in `root`, which may be on another file system than
/// the database; tried before it is stored. Throws InputError where they lie elsewhere already, or
/// where the folder cannot be used.
void choose_job_folder(db::Connection& connection, const std::filesystem::path& root);

/// What a running worker says of itself about once a second.
struct WorkerProgress {
  double time_s = 0;
  double end_time_s = 0;      ///< at the latest
  double expected_end_s = 0;  ///< expected_end_s() of the scene
  long step = 0;
  double particle_steps = 0;  ///< of the job, earlier attempts included
  double wall_s = 0;          ///< of this worker
  long pid = 0;
};
nlohmann::json to_json(const WorkerProgress& progress);

/// Nothing where the file is missing or unreadable.
std::optional<WorkerProgress> read_progress(const JobDirectory& directory);

/// What a worker says last of itself: how its attempt ended and what it cost.
struct AttemptEnded {
  int exit_code = -1;
  double core_seconds = 0;
  std::int64_t peak_memory_bytes = 0;
  std::string host;
  long pid = 0;
};
nlohmann::json to_json(const AttemptEnded& ended);
/// Nothing where the attempt goes on, was killed, or its file is unreadable.
std::optional<AttemptEnded> read_ended(const JobDirectory& directory);

/// Why a run cannot give a result; the file's presence makes the job failed.
struct Failure {
  std::string kind;  ///< e.g. "not-finite"
  long step = 0;
  long particle_id = -1;  ///< -1: no single particle is to blame
  std::string message;
};
nlohmann::json to_json(const Failure& failure);
std::optional<Failure> read_failure(const JobDirectory& directory);

/// A JSON file's content, or nothing where it is missing or is not JSON.
std::optional<nlohmann::json> read_json(const std::filesystem::path& path);

}  // namespace eerie::job_folder
