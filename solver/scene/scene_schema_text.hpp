#pragma once

namespace eerie {

/// scene.schema.json, embedded at build time so that the program runs from anywhere.
extern const char* const scene_schema_text;

}  // namespace eerie
