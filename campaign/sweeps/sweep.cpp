#include "campaign/sweeps/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/sweep_schema_text.hpp"
#include "campaign/text/given_file.hpp"
#include "campaign/text/json_file.hpp"
#include "campaign/text/plain_name.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/validate.hpp"

namespace eerie::sweeps {
using nlohmann::json;

namespace {

const json& sweep_schema() {
  static const json schema = json::parse(sweep_schema_text);
  return schema;
}

/// The schema without what text::require_plain_name() and parse_axis() say in better words.
json outline() {
  json schema = sweep_schema();
  schema["properties"]["grid"] = {{"type", "object"}};
  schema["properties"]["points"] = {{"type", "array"}, {"items", json::object()}};
  schema["properties"]["name"] = {{"type", "string"}};
  return schema;
}

/// A field is either shared or in a point or an axis, and an axis only once.
void require_once(const Sweep& sweep) {
  const auto require_not_shared = [&](const std::string& path, const char* part) {
    if (const json* value = find_field(sweep.scene, path))
      throw InputError(
          fmt::format("{}: {} = {} stands in the scene (or in --set or --fidelity) and {} too; "
                      "remove one of them",
                      sweep.where, path, value->dump(), part));
  };
  std::set<std::string> points(sweep.points.paths.begin(), sweep.points.paths.end()), axes;
  for (const std::string& path : points) require_not_shared(path, "in the points");
  for (const Axis& axis : sweep.axes) {
    require_not_shared(axis.path, "is an axis of the grid");
    if (!axes.insert(axis.path).second)
      throw InputError(fmt::format("{}: grid: two axes name the field {}; remove one of them",
                                   sweep.where, axis.path));
    if (points.contains(axis.path))
      throw InputError(
          fmt::format("{}: {} is in the points and an axis of the grid too; remove one "
                      "of them",
                      sweep.where, axis.path));
  }
}

void require_few_enough(const Sweep& sweep) {
  double count = static_cast<double>(std::max<std::size_t>(sweep.points.rows.size(), 1));
  for (const Axis& axis : sweep.axes) count *= static_cast<double>(axis.values.size());
  if (count > static_cast<double>(max_sweep_jobs))
    throw InputError(
        fmt::format("{}: grid: {:.0f} jobs are more than the {} of one sweep; use fewer values "
                    "or several sweeps",
                    sweep.where, count, max_sweep_jobs));
}

/// The grid may stay away where there are points.
void require_grid_or_points(const json& given, const std::string& where) {
  const bool points = given.contains("points") && !given["points"].empty();
  if (!given.contains("grid") && !points)
    throw InputError(where +
                     ": the field \"grid\" is missing, and \"points\" too; for example \"grid\": "
                     "{\"v_imp_cm_per_s\": [20]} or \"points\": [{\"v_imp_cm_per_s\": 20}]");
  if (given.contains("points") && !points)
    throw InputError(where +
                     ": points = []: must hold at least one point, or leave it out; for "
                     "example [{\"v_imp_cm_per_s\": 20}]");
  if (given.contains("grid") && given["grid"].empty())
    throw InputError(where +
                     ": grid = {}: must have at least one axis; for example "
                     "\"grid\": {\"v_imp_cm_per_s\": [20]}");
}

/// One point as an axis of one value for each of its fields, in the order of their paths.
std::map<std::string, double> parse_point(const json& point, const std::string& where) {
  if (!point.is_object() || point.empty())
    throw InputError(
        where +
        ": must be an object with at least one field; for example {\"v_imp_cm_per_s\": 20}");
  std::map<std::string, double> values;
  for (const auto& [name, value] : point.items()) {
    const std::string field = where + "." + name;
    if (!value.is_number())
      throw InputError(fmt::format("{} = {}: must be a number; for example 20", field,
                                   value.dump(-1, ' ', false, json::error_handler_t::replace)));
    const Axis axis = parse_axis(name, json::array({value}), field);
    if (!values.emplace(axis.path, axis.values.front()).second)
      throw InputError(fmt::format("{}: names the field {} a second time; remove one of them",
                                   field, axis.path));
  }
  return values;
}

SweepPoints parse_points(const json& given, const std::string& where) {
  SweepPoints points;
  std::map<std::vector<double>, std::size_t> seen;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const std::string here = fmt::format("{}[{}]", where, k);
    std::vector<std::string> paths;
    std::vector<double> row;
    for (const auto& [path, value] : parse_point(given[k], here))
      paths.push_back(path), row.push_back(value);
    if (k == 0) points.paths = paths;
    if (paths != points.paths)
      throw InputError(
          fmt::format("{}: has the fields {} and {}[0] has {}; give all points the "
                      "same fields, or make two sweeps",
                      here, fmt::join(paths, ", "), where, fmt::join(points.paths, ", ")));
    if (const auto [at, is_new] = seen.emplace(row, k); !is_new)
      throw InputError(
          fmt::format("{}: is the same as {}[{}]; remove one of them", here, where, at->second));
    points.rows.push_back(std::move(row));
  }
  return points;
}

/// The fields of a sweep's document, each valid by itself.
Sweep fields_of(const json& given, const std::vector<std::string>& overrides,
                const std::string& where) {
  require_valid(outline(), given, where + ": sweep");
  Sweep sweep{given["name"], with_integers(given.value("scene", json::object())), {}, {}, where};
  text::require_plain_name(sweep.name, where + ": name", "first-light");
  require_valid(scene_schema(), sweep.scene, where + ": scene");
  apply_overrides(sweep.scene, overrides);
  require_grid_or_points(given, where);
  if (given.contains("points")) sweep.points = parse_points(given["points"], where + ": points");
  const json grid = given.value("grid", json::object());
  for (const auto& [name, spec] : grid.items())
    sweep.axes.push_back(parse_axis(name, spec, where + ": grid." + name));
  return sweep;
}

}  // namespace

Sweep parse_sweep(const json& given, const std::vector<std::string>& overrides,
                  const std::string& where) {
  Sweep sweep = fields_of(given, overrides, where);
  require_once(sweep);
  require_few_enough(sweep);
  return sweep;
}

Sweep load_sweep(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return parse_sweep(text::load_given_json(path), overrides, text::given_name(path));
}

Scene load_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  const std::string where = text::given_name(path);
  json document = with_integers(text::load_given_json(path));
  require_valid(scene_schema(), document, where);
  apply_overrides(document, overrides);
  return parse_scene(over_default_fidelity(document), where);
}

std::size_t point_count(const Sweep& sweep) {
  std::size_t count = std::max<std::size_t>(sweep.points.rows.size(), 1);
  for (const Axis& axis : sweep.axes) count *= axis.values.size();
  return count;
}

std::vector<Scene> expand(const Sweep& sweep) {
  // One scene is parsed; the others are that scene with other values. These were checked when the
  // sweep was parsed, so that of a combination only remains whether its values fit together.
  const std::string where = sweep.where + ": scene";
  const SweepPoints& points = sweep.points;
  json first = over_default_fidelity(sweep.scene);
  for (std::size_t k = 0; k < points.paths.size(); ++k)
    set_field(first, points.paths[k], canonical_number(points.rows.front()[k]));
  for (const Axis& axis : sweep.axes)
    set_field(first, axis.path, canonical_number(axis.values.front()));
  const Scene base = parse_scene(first, where);

  std::vector<FieldChange> changes;
  for (const std::string& path : points.paths) changes.push_back({field_pointer(path), 0});
  for (const Axis& axis : sweep.axes) changes.push_back({field_pointer(axis.path), 0});
  std::vector<Scene> scenes;
  scenes.reserve(point_count(sweep));
  for (std::size_t point = 0; point < point_count(sweep); ++point) {
    std::size_t rest = point;
    for (std::size_t k = sweep.axes.size(); k-- > 0;) {
      const std::vector<double>& values = sweep.axes[k].values;
      changes[points.paths.size() + k].value = values[rest % values.size()];
      rest /= values.size();
    }
    for (std::size_t k = 0; k < points.paths.size(); ++k) changes[k].value = points.rows[rest][k];
    scenes.push_back(changed(base, changes, where));
  }
  return scenes;
}

std::string document(const Sweep& sweep) {
  json whole = {{"name", sweep.name}, {"scene", over_default_fidelity(sweep.scene)}};
  for (const Axis& axis : sweep.axes) {
    json values = json::array();
    for (const double value : axis.values) values.push_back(canonical_number(value));
    whole["grid"][axis.path] = std::move(values);
  }
  for (const std::vector<double>& row : sweep.points.rows) {
    json point;
    for (std::size_t k = 0; k < row.size(); ++k)
      point[sweep.points.paths[k]] = canonical_number(row[k]);
    whole["points"].push_back(std::move(point));
  }
  return whole.dump();
}

}  // namespace eerie::sweeps
