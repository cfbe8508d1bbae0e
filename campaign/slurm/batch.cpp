#include "campaign/slurm/batch.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <random>

#include "solver/base/file.hpp"
#include "solver/base/files/folders.hpp"
#include "solver/base/text/shell_word.hpp"

namespace eerie::slurm {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr int manifest_version = 1;

std::vector<std::vector<BatchJob>> parse_array(const json& document) {
  std::vector<std::vector<BatchJob>> array;
  for (const json& pack : document.at("array")) {
    array.emplace_back();
    for (const json& job : pack)
      array.back().push_back({job.at("job").get<std::int64_t>(),
                              job_folder::JobDirectory{job.at("directory").get<std::string>()}});
  }
  return array;
}

}  // namespace

fs::path batches_folder(const fs::path& jobs_folder) { return jobs_folder / "batches"; }

std::string new_batch_id() {
  std::random_device random;
  return fmt::format("{:%Y%m%dT%H%M%S}-{:08x}", fmt::gmtime(std::time(nullptr)), random());
}

std::string manifest_text(const Batch& batch) {
  json array = json::array();
  for (const std::vector<BatchJob>& pack : batch.array) {
    json jobs = json::array();
    for (const BatchJob& job : pack)
      jobs.push_back({{"job", job.job}, {"directory", job.directory.path.string()}});
    array.push_back(std::move(jobs));
  }
  return json{{"version", manifest_version}, {"array", std::move(array)}}.dump() + "\n";
}

std::string batch_script(const fs::path& program, const fs::path& folder) {
  return fmt::format("#!/bin/sh\nexec {} slurm-task {}\n", shell_word(program.string()),
                     shell_word(folder.string()));
}

void install_batch(Batch& batch, const fs::path& program) {
  make_folders(batch.folder);
  install_text(batch.script(), batch_script(program, batch.folder));
  install_text(batch.manifest(), manifest_text(batch));
  batch.submitted = fs::last_write_time(batch.manifest());
}

void install_slurm_id(Batch& batch, const SlurmJobId& id) {
  batch.slurm_id = id;
  const std::string cluster = id.cluster.empty() ? "" : ";" + id.cluster;
  install_text(batch.slurm_id_file(), fmt::format("{}{}\n", id.number, cluster));
}

std::optional<Batch> read_batch(const fs::path& folder) {
  Batch batch;
  batch.folder = folder;
  const auto document = job_folder::read_json(batch.manifest());
  if (!document || !document->is_object()) return std::nullopt;
  try {
    if (document->at("version") != manifest_version) return std::nullopt;
    batch.array = parse_array(*document);
  } catch (const json::exception&) {
    return std::nullopt;
  }
  batch.submitted = fs::last_write_time(batch.manifest());
  std::error_code ignored;
  if (fs::is_regular_file(batch.slurm_id_file(), ignored))
    batch.slurm_id = submitted_id(read_file(batch.slurm_id_file()));
  return batch;
}

void install_released(const Batch& batch, const std::set<std::int64_t>& jobs) {
  install_text(batch.released_file(), json(jobs).dump() + "\n");
}

std::set<std::int64_t> read_released(const Batch& batch) {
  const auto document = job_folder::read_json(batch.released_file());
  if (!document || !document->is_array()) return {};
  std::set<std::int64_t> jobs;
  for (const json& job : *document)
    if (job.is_number_integer()) jobs.insert(job.get<std::int64_t>());
  return jobs;
}

void remove_batch(const Batch& batch) {
  // What cannot be removed now (a file still open, over NFS) goes when the next manager starts.
  std::error_code ignored;
  fs::remove(batch.manifest(), ignored);
  fs::remove_all(batch.folder, ignored);
}

}  // namespace eerie::slurm
