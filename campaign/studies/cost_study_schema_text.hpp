#pragma once

namespace eerie::studies {

/// cost_study.schema.json, embedded by the build.
extern const char* const cost_study_schema_text;

}  // namespace eerie::studies
