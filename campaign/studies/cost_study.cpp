#include "campaign/studies/cost_study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/studies/cost_study_schema_text.hpp"
#include "campaign/sweeps/document_kind.hpp"
#include "campaign/sweeps/fidelity.hpp"
#include "campaign/sweeps/scene_field.hpp"
#include "campaign/text/given_file.hpp"
#include "campaign/text/json_file.hpp"
#include "campaign/text/plain_name.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/validate.hpp"

namespace eerie::studies {
using nlohmann::json;

namespace {

const json& cost_study_schema() {
  static const json schema = json::parse(cost_study_schema_text);
  return schema;
}

/// The schema without the pattern of names: require_plain_name() has better words for it.
const json& outline() {
  static const json schema = [] {
    json s = cost_study_schema();
    s["properties"]["name"] = {{"type", "string"}};
    return s;
  }();
  return schema;
}

/// What all cases share: the fidelity's settings, under those of the study's scene.
json shared_scene(const json& given) {
  json scene = json::object();
  if (given.contains("fidelity"))
    sweeps::apply_overrides(scene,
                            sweeps::overrides_of_fidelity(given["fidelity"].get<std::string>()));
  scene.merge_patch(given.value("scene", json::object()));
  return scene;
}

Scene scene_of(const CostStudy& study, const CostRun& run, const std::string& where) {
  const CostStudy::Case& one = study.cases[run.case_index];
  const CostStudy::Setting& setting = study.settings[run.setting];
  const std::string place =
      fmt::format("{}: case {}, {} {}: scene", where, one.name, setting.knob, setting.label);
  json scene = one.scene;
  for (const auto& [path, value] : setting.set.items())
    sweeps::set_field(scene, sweeps::scene_field(path, place).path, value);
  scene["numerics"]["seed"] = run.seed;
  return parse_scene(scene, place);
}

}  // namespace

CostStudy parse_cost_study(const json& given, const std::string& where) {
  require_valid(outline(), given, where + ": study");
  text::require_plain_name(given["name"], where + ": name", "accuracy");
  CostStudy study;
  study.name = given["name"];
  study.document = given;
  const json shared = shared_scene(given);
  for (const json& c : given["cases"]) {
    json scene = shared;
    scene.merge_patch(c["scene"]);
    study.cases.push_back({c["name"], c.value("title", c["name"].get<std::string>()),
                           sweeps::with_integers(std::move(scene))});
  }
  const std::int64_t seeds = given["seeds"];
  study.settings.push_back({default_knob, "", json::object(), seeds});
  for (const json& knob : given["knobs"])
    for (const json& setting : knob["settings"])
      study.settings.push_back(
          {knob["name"], setting["label"], sweeps::with_integers(setting["set"]), seeds});
  const json& reference = given["reference"];
  study.settings.push_back({reference_knob, reference["label"],
                            sweeps::with_integers(reference["set"]), reference["seeds"]});
  // Every scene is checked before anything runs.
  for (std::size_t s = 0; s < study.settings.size(); ++s)
    for (std::size_t c = 0; c < study.cases.size(); ++c) scene_of(study, {s, c, 1, {}}, where);
  return study;
}

CostStudy load_cost_study(const std::filesystem::path& path) {
  const json document = text::load_given_json(path);
  sweeps::require_kind(sweeps::DocumentKind::cost_study, document, text::given_name(path));
  return parse_cost_study(document, text::given_name(path));
}

std::vector<CostRun> runs_of(const CostStudy& study) {
  std::vector<CostRun> runs;
  for (std::size_t s = 0; s < study.settings.size(); ++s)
    for (std::size_t c = 0; c < study.cases.size(); ++c)
      for (std::int64_t seed = 1; seed <= study.settings[s].seeds; ++seed) {
        runs.push_back({s, c, seed, {}});
        runs.back().scene = scene_of(study, runs.back(), study.name);
      }
  std::ranges::stable_sort(runs, {}, &CostRun::seed);
  return runs;
}

}  // namespace eerie::studies
