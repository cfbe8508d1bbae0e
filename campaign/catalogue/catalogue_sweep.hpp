#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "campaign/catalogue/catalogue.hpp"

namespace eerie::catalogue {

/// The fidelity that all rows name; empty where none does. Throws InputError where they differ,
/// since a sweep has one fidelity.
std::string common_fidelity(const Catalogue& catalogue, const std::string& name);

/// Makes a sweep file of the distinct impacts of a catalogue. Fields that all impacts share go into
/// its scene, and the others into its points. `overrides` have the form of --set and precedence.
/// Throws InputError, which names the line, for an impact that makes no scene. `name` is that of
/// the catalogue.
nlohmann::json sweep_of(const Catalogue& catalogue, const std::vector<std::string>& overrides,
                        const std::string& name);

/// A valid name for the sweep of a file.
std::string sweep_name_of(const std::string& stem);

}  // namespace eerie::catalogue
