#include "campaign/sweeps/scene_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/scene_field.hpp"
#include "solver/scene/field_words.hpp"

namespace eerie::sweeps {
using nlohmann::json;

namespace {

/// The fields that a fidelity sets, by dotted path. A field that differs among the rungs which
/// "auto" climbs has null.
std::map<std::string, json> fields_of(const std::string& fidelity) {
  std::map<std::string, json> fields;
  if (fidelity.empty()) return fields;
  if (fidelity != "auto") {
    const json settings = settings_of(fidelity).flatten();
    for (const auto& [pointer, value] : settings.items()) fields[dotted(pointer)] = value;
    return fields;
  }
  for (const Fidelity& rung : fidelities) {
    if (!rung.is_rung) continue;
    for (const auto& [path, value] : fields_of(rung.name))
      if (const auto [known, is_new] = fields.emplace(path, value);
          !is_new && known->second != value)
        known->second = nullptr;
  }
  return fields;
}

bool is_set(const std::vector<std::string>& overrides, const std::string& path) {
  return std::ranges::any_of(overrides, [&](const std::string& text) {
    return full_path(text.substr(0, text.find('='))) == path;
  });
}

}  // namespace

std::vector<std::string> SceneChanges::all() const {
  std::vector<std::string> list;
  if (!fidelity.empty()) list = overrides_of_fidelity(fidelity);
  list.insert(list.end(), overrides.begin(), overrides.end());
  return list;
}

std::vector<std::string> SceneChanges::replaced(const json& scene, const std::string& where) const {
  std::vector<std::string> found;
  for (const auto& [path, value] : fields_of(fidelity)) {
    const json* given = find_field(scene, path);
    if (given == nullptr || *given == value || is_set(overrides, path)) continue;
    const std::string own = word(*given);
    found.push_back(
        fmt::format("{0}: {1} = {2} gives way to --fidelity {3}, which {4}{5}", where, path, own,
                    fidelity, value.is_null() ? "chooses it" : "has " + word(value),
                    value.is_null() ? "" : fmt::format("; --set {}={} keeps it", path, own)));
  }
  return found;
}

}  // namespace eerie::sweeps
