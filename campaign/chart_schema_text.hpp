#pragma once

namespace eerie {

/// chart.schema.json, embedded by the build.
extern const char* const chart_schema_text;

}  // namespace eerie
