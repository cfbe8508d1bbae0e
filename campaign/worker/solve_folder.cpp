#include "campaign/worker/solve_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/job_folder/result_file.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "campaign/text/json_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/file.hpp"
#include "solver/run/checkpoints.hpp"

namespace eerie::worker {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t shown_digits = 16;  // of a hash, as in names of job directories

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(file, ignored));
}

/// What a run leaves in its folder, the newest first.
std::vector<fs::path> work_of_a_run(const job_folder::JobDirectory& directory) {
  std::vector<fs::path> found;
  for (const fs::path& file :
       {directory.result(), directory.final_snapshot(), directory.checkpoint(),
        directory.previous_checkpoint(), directory.path / "last_good.hdf5", directory.history(),
        directory.first_snapshot()})
    if (is_there(file)) found.push_back(file);
  return found;
}

std::string hash_in(const fs::path& scene_file) {
  try {
    return scene_hash(parse_scene(sweeps::over_default_fidelity(text::load_json(scene_file)),
                                  scene_file.string()));
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}; so it cannot be told whose work the folder holds; give another to --out",
                    error.what()));
  }
}

}  // namespace

void require_own_folder(const job_folder::JobDirectory& directory, const Scene& scene) {
  const std::vector<fs::path> work = work_of_a_run(directory);
  if (!is_there(directory.scene())) {
    if (work.empty()) return;
    throw InputError(fmt::format(
        "{}: it holds {} and no scene.json, so it cannot be told whose work that is; give another "
        "folder to --out",
        directory.path.string(), work.front().filename().string()));
  }
  const std::string theirs = hash_in(directory.scene()), ours = scene_hash(scene);
  if (theirs == ours) return;
  throw InputError(fmt::format(
      "{}: it holds {} of another scene ({}; yours is {}); give another folder to --out",
      directory.path.string(), work.empty() ? "the file" : "the work",
      theirs.substr(0, shown_digits), ours.substr(0, shown_digits)));
}

bool is_done(const job_folder::JobDirectory& directory, const Scene& scene, const Note& note) {
  if (!is_there(directory.result())) return false;
  if (job_folder::read_result(directory, scene_hash(scene))) return true;
  const fs::path aside = directory.result().string() + ".unreadable";
  replace_file(directory.result(), aside);
  note(fmt::format("{}: no result of this scene; set aside as {}", directory.result().string(),
                   aside.filename().string()));
  return false;
}

void require_usable_checkpoint(const job_folder::JobDirectory& directory, const Scene& scene,
                               const Note& note) {
  std::vector<std::string> notes;
  const auto usable = run::newest_checkpoint(
      directory.path, scene, [&](const std::string& skipped) { notes.push_back(skipped); });
  if (!usable && !notes.empty())
    throw InputError(fmt::format(
        "{}; a run that starts again would write over it: remove it, or give another folder to "
        "--out",
        notes.front()));
  std::ranges::for_each(notes, note);
}

void keep_scene(const job_folder::JobDirectory& directory, const Scene& scene,
                const fs::path& given) {
  std::error_code ignored;
  if (fs::equivalent(given, directory.scene(), ignored)) return;
  install_text(directory.scene(), to_json(scene).dump(1) + "\n");
}

}  // namespace eerie::worker
