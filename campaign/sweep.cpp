#include "campaign/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/json_file.hpp"
#include "campaign/plain_name.hpp"
#include "campaign/sweep_schema_text.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/validate.hpp"

namespace eerie {
using nlohmann::json;

namespace {

const json& sweep_schema() {
  static const json schema = json::parse(sweep_schema_text);
  return schema;
}

/// The schema without what require_plain_name() and parse_axis() say in better words.
json outline() {
  json schema = sweep_schema();
  schema["properties"]["grid"] = {{"type", "object"}};
  schema["properties"]["name"] = {{"type", "string"}};
  return schema;
}

void require_not_both(const Sweep& sweep, const Axis& axis) {
  if (const json* value = find_field(sweep.scene, axis.path))
    throw InputError(
        fmt::format("{}: {} = {} stands in the scene (or in --set or --fidelity) and is an axis of "
                    "the grid too; "
                    "remove one of them",
                    sweep.where, axis.path, value->dump()));
  for (const Axis& other : sweep.axes)
    if (other.path == axis.path)
      throw InputError(fmt::format("{}: grid: two axes name the field {}; remove one of them",
                                   sweep.where, axis.path));
}

void require_few_enough(const Sweep& sweep) {
  double count = 1;
  for (const Axis& axis : sweep.axes) count *= static_cast<double>(axis.values.size());
  if (count > static_cast<double>(max_sweep_jobs))
    throw InputError(
        fmt::format("{}: grid: {:.0f} jobs are more than the {} of one sweep; use fewer values "
                    "or several sweeps",
                    sweep.where, count, max_sweep_jobs));
}

}  // namespace

Sweep parse_sweep(const json& given, const std::vector<std::string>& overrides,
                  const std::string& where) {
  require_valid(outline(), given, where + ": sweep");
  Sweep sweep{given["name"], with_integers(given.value("scene", json::object())), {}, where};
  require_plain_name(sweep.name, where + ": name", "first-light");
  require_valid(scene_schema(), sweep.scene, where + ": scene");
  apply_overrides(sweep.scene, overrides);
  if (given["grid"].empty())
    throw InputError(where +
                     ": grid = {}: must have at least one axis; for example "
                     "\"grid\": {\"v_imp_cm_per_s\": [20]}");
  for (const auto& [name, spec] : given["grid"].items()) {
    Axis axis = parse_axis(name, spec, where + ": grid." + name);
    require_not_both(sweep, axis);
    sweep.axes.push_back(std::move(axis));
  }
  require_few_enough(sweep);
  require_valid(sweep_schema(), given, where + ": sweep");
  return sweep;
}

Sweep load_sweep(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return parse_sweep(load_json(path), overrides, path.string());
}

std::size_t point_count(const Sweep& sweep) {
  std::size_t count = 1;
  for (const Axis& axis : sweep.axes) count *= axis.values.size();
  return count;
}

std::vector<Scene> expand(const Sweep& sweep) {
  // Each value of each axis is checked against the schema once; of the combinations only whether
  // their values fit together.
  const std::string where = sweep.where + ": scene";
  json first = sweep.scene;
  for (const Axis& axis : sweep.axes)
    set_field(first, axis.path, canonical_number(axis.values.front()));
  const Scene base = parse_scene(first, where);
  for (const Axis& axis : sweep.axes)
    for (const double value : axis.values) {
      json scene = first;
      set_field(scene, axis.path, canonical_number(value));
      parse_scene(scene, where);
    }

  std::vector<FieldChange> changes;
  for (const Axis& axis : sweep.axes) changes.push_back({field_pointer(axis.path), 0});
  std::vector<Scene> scenes;
  scenes.reserve(point_count(sweep));
  for (std::size_t point = 0; point < point_count(sweep); ++point) {
    std::size_t rest = point;
    for (std::size_t k = sweep.axes.size(); k-- > 0;) {
      const std::vector<double>& values = sweep.axes[k].values;
      changes[k].value = values[rest % values.size()];
      rest /= values.size();
    }
    scenes.push_back(changed(base, changes, where));
  }
  return scenes;
}

std::string document(const Sweep& sweep) {
  json grid;
  for (const Axis& axis : sweep.axes) {
    json values = json::array();
    for (const double value : axis.values) values.push_back(canonical_number(value));
    grid[axis.path] = std::move(values);
  }
  return json{{"name", sweep.name}, {"scene", sweep.scene}, {"grid", std::move(grid)}}.dump();
}

}  // namespace eerie
