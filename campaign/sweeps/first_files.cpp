#include "campaign/sweeps/first_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/sweeps/scene_field.hpp"
#include "campaign/sweeps/sweep_schema_text.hpp"
#include "solver/base/text/shell_word.hpp"
#include "solver/scene/scene.hpp"
#include "solver/scene/validate.hpp"

namespace eerie::sweeps {
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* sweep_text = R"({
  "$schema": "./sweep.schema.json",
  "name": "impacts",
  "description": "impacts of two rubble piles over speed and angle",
  "//": "Names that begin with // are comments. Editors that know JSON Schema complete all others.",

  "scene": {
    "// 1": "What all impacts share. Every field that is not here has its default.",
    "// 2": "Particles and the end of a run come from --fidelity: sketch, survey, standard or fine.",
    "target": { "radius_m": 50 },
    "material": { "rho0_kg_per_m3": 2700 }
  },

  "grid": {
    "// 1": "Each combination of these values is one impact. Any field of the scene may be an axis.",
    "// 2": "q: mass of the impactor over that of the target, at most 1.",
    "q": [1],
    "// 3": "phi_d_deg: friction angle of the rubble. 40 is that of lunar sand.",
    "phi_d_deg": [40],
    "// 4": "Speed at contact. The two bodies escape from each other above 6.1 cm/s.",
    "v_imp_cm_per_s": { "from": 16, "to": 24, "step": 4 },
    "// 5": "Angle at contact: 0 is head-on, 90 would be grazing.",
    "theta_imp_deg": [10, 15, 20]
  }
}
)";

constexpr const char* scene_text = R"({
  "$schema": "./scene.schema.json",
  "//": "One impact. Every field that is not here has its default.",
  "target": { "radius_m": 50 },
  "impact": { "q": 1, "v_imp_cm_per_s": 20, "theta_imp_deg": 15 },
  "material": { "rho0_kg_per_m3": 2700, "drucker_prager": { "phi_d_deg": 40 } },
  "numerics": { "particles_per_target": 1000 }
}
)";

constexpr const char* comments = "^//";

/// Lets comments stand in every object of a schema.
void allow_comments(json& schema) {
  if (!schema.is_object()) return;
  if (schema.value("type", json()) == "object" && schema.contains("properties"))
    schema["patternProperties"][comments] = {{"type", "string"}};
  for (const auto& [key, part] : schema.items())
    if (key == "properties")
      for (json& child : part) allow_comments(child);
    else if (key == "items")
      allow_comments(part);
}

json with_schema_member(json schema) {
  schema["properties"]["$schema"] = {{"type", "string"}};
  return schema;
}

/// A schema of axes: each field by its path, and the short names, with the values of the field.
json axes_schema() {
  json axes = {{"type", "object"}, {"minProperties", 1}, {"additionalProperties", false}};
  const auto add = [&](const std::string& name) {
    const SceneField field = scene_field(name, name);
    if (field.schema->value("type", "") == "array" || field.path.starts_with("output.")) return;
    json value = *field.schema;
    value.erase("description"), value.erase("default");
    json list = {{"type", "array"}, {"items", value}, {"minItems", 1}, {"uniqueItems", true}};
    json axis = {{"anyOf", json::array({list})}};
    if (is_numeric(field))
      axis["anyOf"].push_back(
          {{"type", "object"},
           {"additionalProperties", false},
           {"required", {"from", "to", "step"}},
           {"properties", {{"from", value}, {"to", value}, {"step", {{"type", "number"}}}}}});
    axis["description"] = field.schema->value("description", "");
    axes["properties"][name] = std::move(axis);
  };
  for (const ShortName& entry : short_names) add(std::string(entry.name));
  for (const std::string& path : field_paths()) add(path);
  return axes;
}

}  // namespace

std::string scene_schema_for_editors() {
  json schema = with_schema_member(scene_schema());
  allow_comments(schema);
  return schema.dump(1) + "\n";
}

std::string sweep_schema_for_editors() {
  json schema = with_schema_member(json::parse(sweep_schema_text));
  json scene = scene_schema();
  scene.erase("$schema");
  schema["properties"]["scene"] = std::move(scene);
  schema["properties"]["grid"] = axes_schema();
  allow_comments(schema);
  return schema.dump(1) + "\n";
}

FirstFiles first_files(const fs::path& folder) {
  const auto path_of = [&](const char* name) {
    return shell_word((folder.lexically_normal() / name).lexically_normal().string());
  };
  const std::string sweep = path_of("impacts.json"), scene = path_of("scene.json");
  const std::string database = path_of("impacts.sqlite");
  return {{{"impacts.json", sweep_text},
           {"scene.json", scene_text},
           {"sweep.schema.json", sweep_schema_for_editors()},
           {"scene.schema.json", scene_schema_for_editors()}},
          {{fmt::format("eerie expand {}", sweep), "how many impacts it has and what they cost"},
           {fmt::format("eerie run {} --db {} --fidelity survey", sweep, database),
            "all of them, in a minute or two"},
           {fmt::format("eerie solve {} --out {}", scene, path_of("impact")),
            "one impact alone, without a database"}}};
}

}  // namespace eerie::sweeps
