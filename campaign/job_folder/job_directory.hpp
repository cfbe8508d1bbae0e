#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "db/store/connection.hpp"

namespace eerie::job_folder {

/// The folder through which manager and worker communicate (docs/reference/files.md). Every file in
/// it is installed atomically.
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
  /// JobFolder::bodies() of the folder in which it lies.
  std::filesystem::path shared_bodies() const;
};

/// The folder of the job directories of a campaign.
struct JobFolder {
  std::filesystem::path root;
  /// The directory of a job: root / the first 16 hexadecimal digits of its hash.
  JobDirectory of(const std::string& hash) const { return {root / hash.substr(0, 16)}; }
  /// Bodies at rest, which jobs share (solver/run/kept_bodies.hpp).
  std::filesystem::path bodies() const { return root / "bodies"; }
};

/// The job folder of a database: the one that it names, or "<database>.jobs".
JobFolder job_folder(const db::Connection& connection);

/// Makes the folder and tries to write in it. Throws EnvironmentError with the reason where it
/// cannot be used, and DiskFullError where the disk is full.
void require_usable(const std::filesystem::path& root);

/// Makes the directory and checks that everything that manager and worker open in it is a file.
/// Throws EnvironmentError, which names the obstacle.
void require_usable(const JobDirectory& directory);

/// Throws EnvironmentError where something other than a file, a pipe for instance, has the name of
/// one: who opens it would wait for ever.
void require_file(const std::filesystem::path& path);

/// Puts the job directories of a database into `root`, which may be on another file system. It
/// tries the folder before it stores the choice. Throws InputError where they are elsewhere
/// already, or where the folder cannot be used.
void choose_job_folder(db::Connection& connection, const std::filesystem::path& root);

/// The report of a running worker, about once a second.
struct WorkerProgress {
  double time_s = 0;
  double end_time_s = 0;      ///< the latest possible end
  double expected_end_s = 0;  ///< expected_end_s() of the scene
  long step = 0;
  double particle_steps = 0;  ///< of the job, with earlier attempts
  double wall_s = 0;          ///< of this worker
  long pid = 0;
};
nlohmann::json to_json(const WorkerProgress& progress);

/// Reads the report; nothing where the file is missing or unreadable.
std::optional<WorkerProgress> read_progress(const JobDirectory& directory);

/// The last report of a worker: how its attempt ended and what it cost.
struct AttemptEnded {
  int exit_code = -1;
  double core_seconds = 0;
  std::int64_t peak_memory_bytes = 0;
  std::string host;
  long pid = 0;
};
nlohmann::json to_json(const AttemptEnded& ended);
/// Reads the last report; nothing where the attempt is running or was killed, or where the file is
/// unreadable.
std::optional<AttemptEnded> read_ended(const JobDirectory& directory);

/// The reason why a run cannot give a result. A job with this file has failed.
struct Failure {
  std::string kind;  ///< e.g. "not-finite"
  long step = 0;
  long particle_id = -1;  ///< -1 where no single particle caused it
  std::string message;
};
nlohmann::json to_json(const Failure& failure);
std::optional<Failure> read_failure(const JobDirectory& directory);

/// The content of a JSON file; nothing where it is missing or is not JSON.
std::optional<nlohmann::json> read_json(const std::filesystem::path& path);

}  // namespace eerie::job_folder
