#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "campaign/catalogue/catalogue.hpp"

namespace eerie::catalogue {

/// The fidelity that all rows name; empty where none does. Throws InputError where they differ:
/// a sweep has one.
std::string common_fidelity(const Catalogue& catalogue, const std::string& name);

/// A sweep file of the catalogue's impacts, each once: fields in which all agree stand in its
/// scene, the others in its points. `overrides` as --set gives them go on top. Throws InputError,
/// naming the line, for an impact that makes no scene; `name` is the catalogue's.
nlohmann::json sweep_of(const Catalogue& catalogue, const std::vector<std::string>& overrides,
                        const std::string& name);

/// A name for the sweep of a file, of the letters that it may have.
std::string sweep_name_of(const std::string& stem);

}  // namespace eerie::catalogue
