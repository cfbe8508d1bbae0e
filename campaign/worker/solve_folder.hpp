#pragma once

#include <functional>
#include <string>

#include "campaign/job_folder/job_directory.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::worker {

/// Called with a sentence for people.
using Note = std::function<void(const std::string&)>;

/// Throws InputError where the folder has the work or the scene file of another scene, or work
/// whose scene is not known. A folder that does not exist or has no such files is free for any
/// scene.
void require_own_folder(const job_folder::JobDirectory& directory, const Scene& scene);

/// Whether the folder has the result of this scene. It sets another file in its place aside and
/// notes that.
bool is_done(const job_folder::JobDirectory& directory, const Scene& scene, const Note& note);

/// Throws InputError where there are checkpoints and a run can continue from none. They may be
/// hours of work of another version of the program, and a new run would overwrite them. It notes
/// checkpoints that are skipped.
void require_usable_checkpoint(const job_folder::JobDirectory& directory, const Scene& scene,
                               const Note& note);

/// Writes scene.json, unless `given` is that file.
void keep_scene(const job_folder::JobDirectory& directory, const Scene& scene,
                const std::filesystem::path& given);

}  // namespace eerie::worker
