#pragma once

namespace eerie {

/// study.schema.json, embedded by the build.
extern const char* const study_schema_text;

}  // namespace eerie
