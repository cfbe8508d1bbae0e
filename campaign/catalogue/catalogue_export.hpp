#pragma once

#include <string>

#include "db/view.hpp"

namespace eerie {

/// Results as a catalogue of collisions (docs/catalogue.md), one line each. Masses of remnants are
/// those of bound groups. `query` chooses and orders the results.
std::string catalogue_csv(const db::Connection& connection, const db::ViewQuery& query);

}  // namespace eerie
