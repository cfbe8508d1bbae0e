#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace eerie {

/// Checks `document` against a JSON Schema. Throws InputError for the first fault, as
/// "<where>.impact.q = 2: must be greater than 0 and at most 1 (impactor mass over target mass);
/// for example 1". For an unknown field the message lists the known ones. `schema` must live as
/// long as the program, which compiles it once.
void require_valid(const nlohmann::json& schema, const nlohmann::json& document,
                   const std::string& where);

/// The sub-schema at a dotted path ("impact.q"), or nullptr where the schema has none.
const nlohmann::json* schema_at(const nlohmann::json& schema, const std::string& dotted_path);

/// Puts the schema's default wherever `document` lacks a field, at any depth.
nlohmann::json with_defaults(const nlohmann::json& schema, nlohmann::json document);

}  // namespace eerie
