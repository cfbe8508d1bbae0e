#pragma once

#include <string>

#include "db/views/view.hpp"

namespace eerie::catalogue {

/// Results as a catalogue of collisions (docs/reference/catalogue.md) with one line per result. Masses of
/// remnants are those of bound groups. `query` chooses and orders the results.
std::string catalogue_csv(const db::Connection& connection, const db::ViewQuery& query);

}  // namespace eerie::catalogue
