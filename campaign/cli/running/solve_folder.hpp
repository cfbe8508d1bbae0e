#pragma once

#include "campaign/job_folder/job_directory.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::cli {

/// Throws InputError where the folder holds the work, or the scene file, of another scene, or work
/// of which it cannot be told whose it is. A folder that does not exist, or without such files, is
/// free for any scene.
void require_own_folder(const job_folder::JobDirectory& directory, const Scene& scene);

/// Whether the folder holds the result of this scene. A file in its place that is none is set aside
/// and told of.
bool is_done(const job_folder::JobDirectory& directory, const Scene& scene);

/// Throws InputError where there are checkpoints and none can be gone on from: they may be hours of
/// work for another version of the program, and a run that starts again writes over them. Tells of
/// those that are passed over.
void require_usable_checkpoint(const job_folder::JobDirectory& directory, const Scene& scene);

/// Writes scene.json, unless that is the very file that `given` names.
void keep_scene(const job_folder::JobDirectory& directory, const Scene& scene,
                const std::filesystem::path& given);

}  // namespace eerie::cli
