#include "campaign/results/settings_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/scene/field_words.hpp"
#include "solver/scene/scene.hpp"
#include "solver/scene/schemes.hpp"
#include "solver/scene/validate.hpp"

namespace eerie::results {
using nlohmann::json;

namespace {

constexpr std::size_t most_fields = 5;

/// Whether a scene has this field as its scheme makes it; then the scheme's name says it.
bool is_of_scheme(const json& scene, const std::string& field) {
  const std::string group = "/numerics/";
  const json scheme = scene.value(group + "scheme", json());
  if (!field.starts_with(group) || field == group + "scheme") return false;
  if (std::ranges::none_of(schemes, [&](const Scheme& one) { return scheme == one.token; }))
    return false;
  if (!scene.contains(field)) return true;  // off, and the scheme does not turn it on
  const std::string name = field.substr(group.size());
  const json& of_scheme = numerics_of_scheme(scheme);
  if (of_scheme.contains(name)) return of_scheme.at(name) == scene.at(field);
  const json* schema = schema_at(scene_schema(), "numerics." + name);
  return schema != nullptr && schema->value("default", json()) == scene.at(field);
}

/// Fields by pointer in which not all scenes agree, but for what their schemes say already. What
/// most decides a result comes first.
std::vector<std::string> differing(const std::vector<json>& scenes) {
  std::set<std::string> fields;
  for (const json& scene : scenes)
    for (const auto& [field, value] : scene.items()) fields.insert(field);
  std::vector<std::string> found;
  for (const std::string& field : fields)
    if (!std::ranges::all_of(scenes, [&](const json& s) { return is_of_scheme(s, field); }) &&
        std::ranges::any_of(scenes, [&](const json& s) {
          return s.value(field, json()) != scenes.front().value(field, json());
        }))
      found.push_back(field);
  std::ranges::stable_partition(found, [](const std::string& field) {
    return field == "/numerics/particles_per_target" || field == "/numerics/scheme";
  });
  return found;
}

}  // namespace

std::vector<SettingsDifference> differences(const db::Connection& connection,
                                            const std::set<std::int64_t>& ids) {
  std::vector<SettingsDifference> found;
  std::vector<json> scenes;
  for (db::JobSettings& one : db::job_settings(connection))
    if (ids.contains(one.id)) {
      scenes.push_back(json::parse(one.scene).flatten());
      found.push_back({std::move(one), ""});
    }
  const std::vector<std::string> fields = differing(scenes);
  for (std::size_t k = 0; k < found.size(); ++k)
    found[k].fields = field_words(scenes[k], fields, most_fields);
  return found;
}

std::string settings_choices(const db::Connection& connection, const std::set<std::int64_t>& ids) {
  const std::vector<SettingsDifference> choices = differences(connection, ids);
  std::string text;
  for (const auto& [settings, fields] : choices) {
    // A name may have meant something else to an older version of the program.
    const bool tells = !settings.fidelity.empty() &&
                       std::ranges::count_if(choices, [&](const SettingsDifference& other) {
                         return other.settings.fidelity == settings.fidelity;
                       }) == 1;
    text += fmt::format(
        "\n  {:<19} {}",
        tells ? "--fidelity " + settings.fidelity : fmt::format("--settings {}", settings.id),
        fields);
  }
  return text;
}

void require_one_settings(const db::Connection& connection, const std::set<std::int64_t>& ids) {
  if (ids.size() > 1)
    throw InputError(
        fmt::format("{}: holds impacts of {} settings, which are not mixed; choose one by{}",
                    connection.path().string(), ids.size(), settings_choices(connection, ids)));
}

}  // namespace eerie::results
