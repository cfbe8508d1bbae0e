#include "campaign/sweeps/scene_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "campaign/text/closest_names.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/scene.hpp"
#include "solver/scene/validate.hpp"

namespace eerie::sweeps {
using nlohmann::json;

std::string field_pointer(const std::string& path) {
  std::string text = "/" + path;
  std::replace(text.begin(), text.end(), '.', '/');
  return text;
}

std::string word(const json& value) {
  return value.is_string() ? value.get<std::string>()
                           : value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string full_path(const std::string& name) {
  for (const ShortName& entry : short_names)
    if (entry.name == name) return std::string(entry.path);
  return name;
}

namespace {

json::json_pointer pointer(const std::string& path) {
  return json::json_pointer(field_pointer(path));
}

void collect_leaves(const json& schema, const std::string& prefix,
                    std::vector<std::string>& paths) {
  for (const auto& [name, child] : schema.at("properties").items()) {
    if (child.value("type", "") == "object")
      collect_leaves(child, prefix + name + ".", paths);
    else
      paths.push_back(prefix + name);
  }
}

std::string closest_fields(const std::string& given) {
  return text::closest_names(given, field_paths());
}

}  // namespace

std::vector<std::string> field_paths() {
  std::vector<std::string> paths;
  collect_leaves(scene_schema(), "", paths);
  return paths;
}

std::vector<std::string> shared_field_paths() {
  std::vector<std::string> paths = field_paths();
  std::erase_if(paths,
                [](const std::string& path) { return path.starts_with("impactor.material."); });
  return paths;
}

SceneField scene_field(const std::string& name, const std::string& where) {
  const std::string path = full_path(name);
  const json* schema = schema_at(scene_schema(), path);
  if (schema == nullptr)
    throw InputError(fmt::format("{}: the scene has no field \"{}\"; the closest are {}", where,
                                 name, closest_fields(name)));
  if (schema->value("type", "") == "object")
    throw InputError(
        fmt::format("{}: \"{}\" is a group of fields; name one of its fields, for example {}",
                    where, name, closest_fields(name)));
  return {path, schema};
}

bool is_numeric(const SceneField& field) {
  const std::string type = field.schema->value("type", "");
  return type == "number" || type == "integer";
}

const json* find_field(const json& scene, const std::string& path) {
  const auto at = pointer(path);
  return scene.is_structured() && scene.contains(at) ? &scene.at(at) : nullptr;
}

void set_field(json& scene, const std::string& path, json value) {
  scene[pointer(path)] = std::move(value);
}

void erase_field(json& scene, const std::string& path) {
  const auto at = pointer(path);
  if (at.empty() || !scene.contains(at)) return;
  json& group = scene.at(at.parent_pointer());
  group.erase(at.back());
  if (group.empty() && !at.parent_pointer().empty()) {
    const auto of_group = at.parent_pointer();
    scene.at(of_group.parent_pointer()).erase(of_group.back());
  }
}

namespace {

void apply_override(json& scene, const std::string& path_and_value) {
  const std::string where = "--set " + path_and_value;
  const std::size_t equals = path_and_value.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError(where +
                     ": must be PATH=VALUE, for example --set numerics.particles_per_target=1000");
  const SceneField field = scene_field(path_and_value.substr(0, equals), where);
  const std::string text = path_and_value.substr(equals + 1);
  json value = text;
  if (field.schema->value("type", "") != "string") {
    const json parsed = json::parse(text, nullptr, false);
    if (parsed.is_number()) value = canonical_number(parsed.get<double>());
    if (parsed.is_boolean()) value = parsed;
  }
  require_valid(*field.schema, value, "--set " + field.path);
  set_field(scene, field.path, std::move(value));
}

}  // namespace

void apply_overrides(json& scene, const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides) apply_override(scene, text);
}

double rounded(double value) {
  return std::strtod(fmt::format("{:.{}g}", value, significant_digits).c_str(), nullptr) + 0.0;
}

json canonical_number(double value) {
  // Integers are exact, seeds for instance.
  const auto is_integer = [&] { return value == std::floor(value) && std::abs(value) < 0x1p53; };
  if (!is_integer()) value = rounded(value);
  if (is_integer()) return static_cast<std::int64_t>(value);
  return value;
}

json with_integers(json document) {
  if (document.is_structured()) {
    for (json& child : document) child = with_integers(std::move(child));
  } else if (document.is_number_float()) {
    document = canonical_number(document.get<double>());
  }
  return document;
}

}  // namespace eerie::sweeps
