#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "campaign/job_folder/job_directory.hpp"
#include "campaign/slurm/queue_text.hpp"

namespace eerie::slurm {

/// A job of a batch.
struct BatchJob {
  std::int64_t job = 0;
  job_folder::JobDirectory directory;
};

/// One submission: an array job whose array tasks each run some jobs, one after another. Its folder
/// has everything that either side needs, and lives as long as the batch. An array task that starts
/// without the folder does nothing.
struct Batch {
  std::filesystem::path folder;  ///< its last part is the id of the batch
  std::vector<std::vector<BatchJob>> array;
  std::optional<SlurmJobId> slurm_id;           ///< nothing: not known yet
  std::filesystem::file_time_type submitted{};  ///< older news in a job directory are another's

  std::string cluster() const { return slurm_id ? slurm_id->cluster : ""; }
  std::string id() const { return folder.filename().string(); }
  std::string name() const { return "eerie-" + id(); }  ///< the name of the job in Slurm
  std::filesystem::path manifest() const { return folder / "manifest.json"; }
  std::filesystem::path script() const { return folder / "batch.sh"; }
  std::filesystem::path slurm_id_file() const { return folder / "slurm_id"; }
  std::filesystem::path released_file() const { return folder / "released.json"; }
  std::filesystem::path output(int index) const {
    return folder / ("output_" + std::to_string(index) + ".txt");
  }
};

/// The folders of batches, beside the job directories.
std::filesystem::path batches_folder(const std::filesystem::path& jobs_folder);

/// Makes a new id. Ids are unique and sort by time.
std::string new_batch_id();

/// Makes the folder with manifest and script, before the submission.
void install_batch(Batch& batch, const std::filesystem::path& program);

/// Notes under which id Slurm knows the batch.
void install_slurm_id(Batch& batch, const SlurmJobId& id);

/// Reads a batch. Nothing where the folder has no readable manifest, so that the batch was never
/// submitted, or is over.
std::optional<Batch> read_batch(const std::filesystem::path& folder);

/// Stores the jobs for which this batch is no longer responsible, although its array task may start
/// again; reads them.
void install_released(const Batch& batch, const std::set<std::int64_t>& jobs);
std::set<std::int64_t> read_released(const Batch& batch);

/// Removes the folder, the manifest first.
void remove_batch(const Batch& batch);

/// The text of the manifest: "version", and "array" with lists of {"job", "directory"}.
std::string manifest_text(const Batch& batch);

/// The script of an array task. The program replaces the shell, so that Slurm's signals reach it.
std::string batch_script(const std::filesystem::path& program, const std::filesystem::path& folder);

}  // namespace eerie::slurm
