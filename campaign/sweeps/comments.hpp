#pragma once

#include <nlohmann/json_fwd.hpp>

namespace eerie::sweeps {

/// A sweep or a scene, as given, without what is for readers and editors alone: "$schema" at its
/// top, and in any object texts under names that begin with "//". Members of these names that are
/// no text stay, and are refused later as unknown fields.
nlohmann::json without_comments(nlohmann::json document);

}  // namespace eerie::sweeps
