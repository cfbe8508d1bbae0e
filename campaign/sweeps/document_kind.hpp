#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace eerie::sweeps {

/// Files that commands read.
enum class DocumentKind { scene, sweep, convergence_study, cost_study, unknown };

/// What a document is by its members. A sweep has a grid or points, a study has cases, and a scene
/// has groups of fields such as "impact".
DocumentKind kind_of(const nlohmann::json& document);

/// Throws InputError, which names the command for it, where a document is plainly of another kind
/// than `wanted`. `where` is the name of its file.
void require_kind(DocumentKind wanted, const nlohmann::json& document, const std::string& where);

/// Throws InputError for the first field of a scene, or of a part of one, that the schema does not
/// have. It names the fields that are likely meant.
void require_known_fields(const nlohmann::json& scene, const std::string& where);

}  // namespace eerie::sweeps
