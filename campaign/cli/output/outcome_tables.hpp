#pragma once

#include "campaign/cli/output/answer.hpp"

namespace eerie::cli {

/// Adds an outcome for people: its class and tables of its remnants. `analysis` is a document of
/// remnants::to_json().
void add_outcome(Answer& answer, const nlohmann::json& analysis);

}  // namespace eerie::cli
