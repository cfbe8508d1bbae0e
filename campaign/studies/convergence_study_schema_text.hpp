#pragma once

namespace eerie::studies {

/// convergence_study.schema.json, embedded by the build.
extern const char* const convergence_study_schema_text;

}  // namespace eerie::studies
