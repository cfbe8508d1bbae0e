#pragma once

namespace eerie::sweeps {

/// sweep.schema.json, embedded at build time so that the program runs from anywhere.
extern const char* const sweep_schema_text;

}  // namespace eerie::sweeps
