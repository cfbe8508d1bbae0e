#include "campaign/scene_field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "solver/base/error.hpp"
#include "solver/scene/scene.hpp"
#include "solver/scene/validate.hpp"

namespace eerie {
using nlohmann::json;

std::string field_pointer(const std::string& path) {
  std::string text = "/" + path;
  std::replace(text.begin(), text.end(), '.', '/');
  return text;
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

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// How far `given` is from a path: people misspell whole paths, forget all but the last part, or
/// shorten that.
std::size_t distance(const std::string& given, const std::string& path) {
  const std::string last = path.substr(path.rfind('.') + 1);
  if (given.size() > 2 && last.find(given) != std::string::npos) return 1;
  return std::min(edit_distance(given, path), edit_distance(given, last));
}

std::string closest_fields(const std::string& given) {
  std::vector<std::string> paths;
  collect_leaves(scene_schema(), "", paths);
  std::stable_sort(paths.begin(), paths.end(), [&](const std::string& a, const std::string& b) {
    return distance(given, a) < distance(given, b);
  });
  paths.resize(3);
  return fmt::format("{}", fmt::join(paths, ", "));
}

}  // namespace

SceneField scene_field(const std::string& name, const std::string& where) {
  std::string path = name;
  for (const ShortName& entry : short_names)
    if (entry.name == name) path = entry.path;
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

const json* find_field(const json& scene, const std::string& path) {
  const auto at = pointer(path);
  return scene.is_structured() && scene.contains(at) ? &scene.at(at) : nullptr;
}

void set_field(json& scene, const std::string& path, json value) {
  scene[pointer(path)] = std::move(value);
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
  }
  require_valid(*field.schema, value, "--set " + field.path);
  set_field(scene, field.path, std::move(value));
}

}  // namespace

void apply_overrides(json& scene, const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides) apply_override(scene, text);
}

json canonical_number(double value) {
  if (value == std::floor(value) && std::abs(value) < 0x1p53)
    return static_cast<std::int64_t>(value);
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

}  // namespace eerie
