#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eerie::sweeps {

/// The JSON pointer of a dotted path: "/impact/q" for "impact.q".
std::string field_pointer(const std::string& path);
/// A value as --set takes it.
std::string word(const nlohmann::json& value);

/// The short names of the fields that every sweep varies.
struct ShortName {
  std::string_view name, path;
};
inline constexpr std::array<ShortName, 4> short_names = {{
    {"q", "impact.q"},
    {"phi_d_deg", "material.drucker_prager.phi_d_deg"},
    {"v_imp_cm_per_s", "impact.v_imp_cm_per_s"},
    {"theta_imp_deg", "impact.theta_imp_deg"},
}};

/// The dotted path of a short name; any other name as it is.
std::string full_path(const std::string& name);

/// A field of the scene and its part of the schema.
struct SceneField {
  std::string path;              ///< dotted, "impact.q"
  const nlohmann::json* schema;  ///< never null
};

/// The dotted paths of all fields of a scene.
std::vector<std::string> field_paths();
/// Without those that stand beside a field of both bodies: a word that names no body means both.
std::vector<std::string> shared_field_paths();

bool is_numeric(const SceneField& field);

/// The field of a dotted path or short name. Throws InputError, which begins with `where` and names
/// the closest known fields, where there is none.
SceneField scene_field(const std::string& name, const std::string& where);

/// The field in a scene's JSON; nullptr where it is missing.
const nlohmann::json* find_field(const nlohmann::json& scene, const std::string& path);
void set_field(nlohmann::json& scene, const std::string& path, nlohmann::json value);
/// Removes the field where it is there, and groups that have no other field.
void erase_field(nlohmann::json& scene, const std::string& path);

/// Applies each "--set PATH=VALUE" in order and checks it against the schema. Throws InputError.
void apply_overrides(nlohmann::json& scene, const std::vector<std::string>& overrides);

/// Numbers of points and scenes that differ only in later digits count as equal:
/// 0.30000000000000004 is 0.3.
inline constexpr int significant_digits = 12;
/// The double nearest to the first significant_digits of a finite number. For -0 it is 0.
double rounded(double value);

/// The canonical form of a number: rounded(), and an integer where the schema wants one (30.0
/// becomes 30).
nlohmann::json canonical_number(double value);

/// `document` with every number in that form.
nlohmann::json with_integers(nlohmann::json document);

}  // namespace eerie::sweeps
