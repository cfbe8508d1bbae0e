#pragma once

namespace eerie::slurm {

/// profile.schema.json, embedded by the build.
extern const char* const slurm_profile_schema_text;

}  // namespace eerie::slurm
