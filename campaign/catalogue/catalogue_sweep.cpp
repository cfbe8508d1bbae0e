#include "campaign/catalogue/catalogue_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "campaign/sweeps/scene_field.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::catalogue {
using nlohmann::json;

namespace {

struct Field {
  const char* path;
  std::optional<double> (*value)(const CatalogueImpact&);
  bool of_every_point;  ///< also where all impacts agree in it
};
constexpr Field fields[] = {
    {"impact.v_imp_cm_per_s",
     [](const CatalogueImpact& i) { return std::optional(i.v_imp_cm_per_s); }, true},
    {"impact.theta_imp_deg",
     [](const CatalogueImpact& i) { return std::optional(i.theta_imp_deg); }, true},
    {"impact.q", [](const CatalogueImpact& i) { return std::optional(i.q); }, false},
    {"target.radius_m", [](const CatalogueImpact& i) { return std::optional(i.radius_m); }, false},
    {"material.rho0_kg_per_m3",
     [](const CatalogueImpact& i) { return std::optional(i.rho0_kg_per_m3); }, false},
    {"material.drucker_prager.phi_d_deg", [](const CatalogueImpact& i) { return i.phi_d_deg; },
     false},
    {"numerics.seed", [](const CatalogueImpact& i) { return i.seed; }, false},
};

/// What the scene of every row says of the field: one value, none, or several.
bool agree(const Catalogue& catalogue, const Field& field) {
  return std::ranges::all_of(catalogue.rows, [&](const CatalogueRow& row) {
    return field.value(row.impact) == field.value(catalogue.rows.front().impact);
  });
}

std::string short_name(const char* path) {
  for (const sweeps::ShortName& entry : sweeps::short_names)
    if (entry.path == path) return std::string(entry.name);
  return path;
}

}  // namespace

std::string common_fidelity(const Catalogue& catalogue, const std::string& name) {
  const CatalogueRow& first = catalogue.rows.front();
  for (const CatalogueRow& row : catalogue.rows)
    if (row.fidelity != first.fidelity)
      throw InputError(fmt::format(
          "{}, line {}: fidelity is \"{}\" and in line {} it is \"{}\"; a sweep has one: give "
          "--fidelity NAME for all, or import a file for each",
          name, row.line, row.fidelity, first.line, first.fidelity));
  return first.fidelity;
}

json sweep_of(const Catalogue& catalogue, const std::vector<std::string>& overrides,
              const std::string& name) {
  json scene = json::object();
  sweeps::apply_overrides(scene, overrides);
  std::vector<const Field*> varied;
  for (const Field& field : fields) {
    if (sweeps::find_field(scene, field.path) != nullptr) continue;  // --set goes before the file
    if (field.of_every_point || !agree(catalogue, field)) {
      varied.push_back(&field);
    } else if (const auto value = field.value(catalogue.rows.front().impact)) {
      sweeps::set_field(scene, field.path, sweeps::canonical_number(*value));
    }
  }
  json points = json::array();
  std::set<std::vector<double>> seen;
  for (const CatalogueRow& row : catalogue.rows) {
    const std::string where = fmt::format("{}, line {}", name, row.line);
    json point, whole = scene;
    std::vector<double> key;
    for (const Field* field : varied) {
      const auto value = field->value(row.impact);
      if (!value)
        throw InputError(
            fmt::format("{}: {} is missing, and other lines have it; give it in every "
                        "line or in none",
                        where, short_name(field->path)));
      key.push_back(*value);
      point[short_name(field->path)] = sweeps::canonical_number(*value);
      sweeps::set_field(whole, field->path, sweeps::canonical_number(*value));
    }
    parse_scene(whole, where);
    if (seen.insert(key).second) points.push_back(std::move(point));
  }
  return {{"name", "catalogue"}, {"scene", std::move(scene)}, {"points", std::move(points)}};
}

std::string sweep_name_of(const std::string& stem) {
  std::string name = stem.substr(0, 64);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_' && c != '.')
      c = '-';
  const std::size_t begin = name.find_first_not_of(".-");
  return begin == std::string::npos ? "catalogue" : name.substr(begin);
}

}  // namespace eerie::catalogue
