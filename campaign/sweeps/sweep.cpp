#include "campaign/sweeps/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "campaign/sweeps/comments.hpp"
#include "campaign/sweeps/document_kind.hpp"
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
std::map<std::string, json> parse_point(const json& point, const std::string& where) {
  if (!point.is_object() || point.empty())
    throw InputError(
        where +
        ": must be an object with at least one field; for example {\"v_imp_cm_per_s\": 20}");
  std::map<std::string, json> values;
  for (const auto& [name, value] : point.items()) {
    const std::string field = where + "." + name;
    if (is_numeric(scene_field(name, field)) && !value.is_number())
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
  std::map<std::vector<json>, std::size_t> seen;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const std::string here = fmt::format("{}[{}]", where, k);
    std::vector<std::string> paths;
    std::vector<json> row;
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
Sweep fields_of(const json& document, const std::vector<std::string>& overrides,
                const std::string& where) {
  const json given = without_comments(document);
  require_kind(DocumentKind::sweep, given, where);
  require_valid(outline(), given, where + ": sweep");
  Sweep sweep{given["name"], with_integers(given.value("scene", json::object())), {}, {}, where};
  text::require_plain_name(sweep.name, where + ": name", "first-light");
  require_known_fields(sweep.scene, where + ": scene");
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

GivenScene load_scene(const std::filesystem::path& path, const SceneChanges& changes) {
  const std::string where = text::given_name(path);
  json document = with_integers(without_comments(text::load_given_json(path)));
  require_kind(DocumentKind::scene, document, where);
  require_known_fields(document, where);
  require_valid(scene_schema(), document, where);
  std::vector<std::string> replaced = changes.replaced(document, where);
  apply_overrides(document, changes.all());
  return {parse_scene(over_default_fidelity(document), where), std::move(replaced)};
}

std::size_t point_count(const Sweep& sweep) {
  std::size_t count = std::max<std::size_t>(sweep.points.rows.size(), 1);
  for (const Axis& axis : sweep.axes) count *= axis.values.size();
  return count;
}

namespace {

/// The fields that a sweep varies, and their values at each of its points.
class Grid {
 public:
  explicit Grid(const Sweep& sweep) : sweep_(sweep), paths_(sweep.points.paths) {
    for (const Axis& axis : sweep.axes) paths_.push_back(axis.path);
  }
  const std::vector<std::string>& paths() const { return paths_; }

  std::vector<json> at(std::size_t point) const {
    const std::size_t of_points = sweep_.points.paths.size();
    std::vector<json> values(paths_.size());
    for (std::size_t k = sweep_.axes.size(); k-- > 0;) {
      const std::vector<json>& axis = sweep_.axes[k].values;
      values[of_points + k] = axis[point % axis.size()];
      point /= axis.size();
    }
    for (std::size_t k = 0; k < of_points; ++k) values[k] = sweep_.points.rows[point][k];
    return values;
  }

 private:
  const Sweep& sweep_;
  std::vector<std::string> paths_;
};

/// A scene of a sweep with the values that its fields have at a point.
Scene parse_at(const Sweep& sweep, const std::vector<std::string>& paths,
               const std::vector<json>& values) {
  json scene = sweep.scene;
  for (std::size_t k = 0; k < paths.size(); ++k)
    if (!values[k].is_number()) set_field(scene, paths[k], values[k]);
  scene = over_default_fidelity(scene);  // which words may decide
  for (std::size_t k = 0; k < paths.size(); ++k) set_field(scene, paths[k], values[k]);
  return parse_scene(scene, sweep.where + ": scene");
}

/// The scene that a sweep's document has. Fields that vary are not in it, so that the document is a
/// sweep again.
json shared_scene(const Sweep& sweep) {
  if (varies_default_fidelity(sweep)) return sweep.scene;
  json scene = over_default_fidelity(sweep.scene);
  const Grid grid(sweep);
  for (const std::string& path : grid.paths()) erase_field(scene, path);
  return scene;
}

}  // namespace

bool varies_default_fidelity(const Sweep& sweep) {
  const Grid grid(sweep);
  return std::ranges::any_of(grid.paths(), [](const std::string& path) {
    return std::ranges::find(fields_against_default, path) != fields_against_default.end();
  });
}

std::vector<Scene> expand(const Sweep& sweep) {
  // One scene is parsed for each combination of words; the others are that scene with other
  // numbers. These were checked when the sweep was parsed, so that of a combination only remains
  // whether its values fit together.
  const Grid grid(sweep);
  std::map<std::vector<json>, Scene> parsed;
  std::vector<Scene> scenes;
  scenes.reserve(point_count(sweep));
  for (std::size_t point = 0; point < point_count(sweep); ++point) {
    const std::vector<json> values = grid.at(point);
    std::vector<json> words;
    std::vector<FieldChange> numbers;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k].is_number())
        numbers.push_back({field_pointer(grid.paths()[k]), values[k].get<double>()});
      else
        words.push_back(values[k]);
    auto base = parsed.find(words);
    if (base == parsed.end())
      base = parsed.emplace(words, parse_at(sweep, grid.paths(), values)).first;
    scenes.push_back(changed(base->second, numbers, sweep.where + ": scene"));
  }
  return scenes;
}

std::string document(const Sweep& sweep) {
  json whole = {{"name", sweep.name}, {"scene", shared_scene(sweep)}};
  for (const Axis& axis : sweep.axes) whole["grid"][axis.path] = axis.values;
  for (const std::vector<json>& row : sweep.points.rows) {
    json point;
    for (std::size_t k = 0; k < row.size(); ++k) point[sweep.points.paths[k]] = row[k];
    whole["points"].push_back(std::move(point));
  }
  return whole.dump();
}

}  // namespace eerie::sweeps
