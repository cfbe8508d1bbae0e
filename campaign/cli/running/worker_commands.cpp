#include "campaign/cli/options/command_list.hpp"
#include "campaign/slurm/array_task.hpp"
#include "campaign/worker/worker.hpp"

namespace eerie::cli {

Action add_worker(CLI::App& app) {
  auto a = std::make_shared<worker::WorkerOptions>();
  app.add_option("DIR", a->directory, "job directory")->required();
  app.add_option("--threads", a->threads, "threads")->check(CLI::Range(1, most_threads));
  app.add_option("--parent", a->parent, "process to end with");
  return [a](Output&) { return Answer(worker::run_worker(*a)); };
}

Action add_slurm_task(CLI::App& app) {
  auto batch = std::make_shared<std::filesystem::path>();
  app.add_option("BATCH", *batch, "folder of the batch")->required();
  return
      [batch](Output&) { return Answer(slurm::run_array_task(slurm::array_task_options(*batch))); };
}

}  // namespace eerie::cli
