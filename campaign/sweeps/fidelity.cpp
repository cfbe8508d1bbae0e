#include "campaign/sweeps/fidelity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/base/error.hpp"
#include "solver/scene/scene.hpp"

namespace eerie::sweeps {
using nlohmann::json;

namespace {

/// "/end/time_s" as "end.time_s".
std::string dotted(std::string pointer) {
  pointer.erase(0, 1);
  std::ranges::replace(pointer, '/', '.');
  return pointer;
}

/// Numerics (without the seed) and end of a fidelity, every field written out.
json whole(const Fidelity& fidelity) {
  json scene = {{"impact", {{"q", 1}, {"v_imp_cm_per_s", 20}, {"theta_imp_deg", 15}}}};
  scene.merge_patch(json::parse(fidelity.settings));
  scene = to_json(parse_scene(scene));
  scene["numerics"].erase("seed");
  return {{"numerics", scene["numerics"]}, {"end", scene["end"]}};
}

}  // namespace

std::vector<std::string> overrides_of_fidelity(const std::string& name) {
  std::string names;
  for (const Fidelity& fidelity : fidelities) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", fidelity.name);
    if (fidelity.name != name) continue;
    std::vector<std::string> overrides;
    const json settings = json::parse(fidelity.settings).flatten();
    for (const auto& [pointer, value] : settings.items())
      overrides.push_back(fmt::format("{}={}", dotted(pointer),
                                      value.is_string() ? value.get<std::string>() : value.dump()));
    return overrides;
  }
  if (name == "auto")
    throw InputError(
        fmt::format("--fidelity auto: only `eerie run` chooses by itself; give one of {}", names));
  throw InputError(fmt::format("--fidelity {}: must be one of {}, auto", name, names));
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
