#include "campaign/sweeps/fidelity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/sweeps/scene_field.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/field_words.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::sweeps {
using nlohmann::json;

namespace {

json settings_of(const Fidelity& fidelity) {
  json settings = fidelity.is_rung ? json::parse(rung_settings) : json::object();
  settings.merge_patch(json::parse(fidelity.settings));
  return settings;
}

/// Numerics (without the seed) and end of a fidelity, every field written out.
json whole(const Fidelity& fidelity) {
  json scene = {{"impact", {{"q", 1}, {"v_imp_cm_per_s", 20}, {"theta_imp_deg", 15}}}};
  scene.merge_patch(settings_of(fidelity));
  scene = to_json(parse_scene(scene));
  scene["numerics"].erase("seed");
  return {{"numerics", scene["numerics"]}, {"end", scene["end"]}};
}

/// Whether the default fidelity is meant for a scene, as given: see fields_against_default.
bool takes_default(const json& scene) {
  const auto given = [&](const char* pointer, const json& otherwise) {
    return scene.value(json::json_pointer(pointer), otherwise);
  };
  return given("/numerics/scheme", "") == "" && given("/environment/self_gravity", true) &&
         given("/material/energy", "none") == "none";
}

}  // namespace

json settings_of(const std::string& name, const std::string& where) {
  std::string names;
  for (const Fidelity& fidelity : fidelities) {
    if (fidelity.name == name) return settings_of(fidelity);
    names += fmt::format("{}{}", names.empty() ? "" : ", ", fidelity.name);
  }
  if (name == "auto")
    throw InputError(
        fmt::format("{} auto: only `eerie run` chooses by itself; give one of {}", where, names));
  throw InputError(fmt::format("{} {}: must be one of {}, auto", where, name, names));
}

std::vector<std::string> overrides_of_fidelity(const std::string& name) {
  std::vector<std::string> overrides;
  const json settings = settings_of(name).flatten();
  for (const auto& [pointer, value] : settings.items())
    overrides.push_back(fmt::format("{}={}", dotted(pointer), word(value)));
  return overrides;
}

json over_default_fidelity(const json& scene) {
  if (!takes_default(scene)) return scene;
  json whole = settings_of(default_fidelity);
  whole.merge_patch(scene);
  return whole;
}

std::vector<std::string> departures(const json& scene, const std::string& where) {
  std::vector<std::string> found;
  if (!takes_default(scene)) return found;
  const json settings = settings_of(default_fidelity).flatten();
  for (const auto& [pointer, value] : settings.items()) {
    const json::json_pointer at(pointer);
    if (scene.contains(at) && scene.at(at) != value)
      found.push_back(fmt::format("{}: {} = {}, where fidelity \"{}\" has {}", where,
                                  dotted(pointer), word(scene.at(at)), default_fidelity,
                                  word(value)));
  }
  return found;
}

std::string_view rung_above(std::string_view name) {
  for (std::size_t k = 0; k + 1 < std::size(fidelities); ++k)
    if (fidelities[k].name == name && fidelities[k].is_rung && fidelities[k + 1].is_rung)
      return fidelities[k + 1].name;
  return "";
}

std::string cheaper_rung(std::string_view name) {
  for (const Fidelity& cheaper : fidelities) {
    if (rung_above(cheaper.name) != name || name.empty()) continue;
    const Fidelity& rung = *std::ranges::find(fidelities, name, &Fidelity::name);
    return fmt::format(
        "--fidelity {} takes {:.0f} % of that; its b/a errs by {:g} in place of {:g}", cheaper.name,
        100 * cheaper.core_seconds / rung.core_seconds, cheaper.error, rung.error);
  }
  return "";
}

std::string_view fidelity_of(const json& canonical) {
  static const std::vector<json> known = [] {
    std::vector<json> all;
    for (const Fidelity& fidelity : fidelities) all.push_back(whole(fidelity));
    return all;
  }();
  json numerics = canonical.at("numerics");
  numerics.erase("seed");
  for (std::size_t k = 0; k < known.size(); ++k)
    if (known[k]["numerics"] == numerics && known[k]["end"] == canonical.at("end"))
      return fidelities[k].name;
  return "";
}

}  // namespace eerie::sweeps
