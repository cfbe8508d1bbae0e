#pragma once

#include "campaign/cli/output/answer.hpp"

namespace eerie::cli {

/// An outcome for people, the class and tables of the remnants, of a document as
/// remnants::to_json() makes it.
void add_outcome(Answer& answer, const nlohmann::json& analysis);

}  // namespace eerie::cli
