#include "campaign/studies/convergence_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "campaign/studies/convergence_study_schema_text.hpp"
#include "campaign/sweeps/document_kind.hpp"
#include "campaign/sweeps/scene_field.hpp"
#include "campaign/text/given_file.hpp"
#include "campaign/text/json_file.hpp"
#include "campaign/text/plain_name.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/schemes.hpp"
#include "solver/scene/validate.hpp"

namespace eerie::studies {
using nlohmann::json;

namespace {

const json& study_schema() {
  static const json schema = json::parse(convergence_study_schema_text);
  return schema;
}

/// The schema without the patterns of names: require_plain_name() has better words for them.
const json& outline() {
  static const json schema = [] {
    json s = study_schema();
    s["properties"]["name"] = {{"type", "string"}};
    s["properties"]["cases"]["items"]["properties"]["name"] = {{"type", "string"}};
    return s;
  }();
  return schema;
}

/// Nothing where there is no such field.
template <class Value>
std::optional<Value> given_as(const json& object, const char* key) {
  return object.contains(key) ? std::optional(object[key].get<Value>()) : std::nullopt;
}

ConvergenceStudy::Case parse_case(const json& given, const json& shared) {
  json scene = shared;
  scene.merge_patch(given["scene"]);
  const json published = given.value("published", json::object());
  const std::string name = given["name"];
  return {name,
          given.value("title", name),
          sweeps::with_integers(std::move(scene)),
          {given_as<double>(published, "b_over_a"), given_as<double>(published, "m_1_over_m_total"),
           given_as<double>(published, "period_h"), given_as<bool>(published, "eer")}};
}

void require_known(const ConvergenceStudy::Rung& rung,
                   const std::vector<ConvergenceStudy::Case>& cases, const std::string& where) {
  for (const std::string& name : rung.cases)
    if (std::ranges::find(cases, name, &ConvergenceStudy::Case::name) == cases.end()) {
      std::string known;
      for (const ConvergenceStudy::Case& c : cases) known += (known.empty() ? "" : ", ") + c.name;
      throw InputError(
          fmt::format("{}: ladder names the case \"{}\"; the cases are {}", where, name, known));
    }
}

void require_known(const std::string& scheme, const std::vector<std::string>& schemes,
                   const std::string& where) {
  if (std::ranges::find(schemes, scheme) == schemes.end())
    throw InputError(fmt::format("{}: by_scheme names the scheme \"{}\"; the schemes are {}", where,
                                 scheme, fmt::join(schemes, ", ")));
}

void require_distinct(const std::vector<ConvergenceStudy::Case>& cases, const std::string& where) {
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (std::size_t j = i + 1; j < cases.size(); ++j)
      if (cases[i].name == cases[j].name)
        throw InputError(fmt::format("{}: two cases have the name \"{}\"; rename one of them",
                                     where, cases[i].name));
}

Scene scene_of(const ConvergenceStudy& study, const ConvergenceStudy::Case& c,
               const std::string& scheme, std::int64_t particles, std::int64_t seed) {
  json scene = c.scene;
  if (const auto own = study.by_scheme.find(scheme); own != study.by_scheme.end())
    scene.merge_patch(own->second);
  scene["numerics"]["scheme"] = scheme;
  scene["numerics"]["particles_per_target"] = particles;
  scene["numerics"]["seed"] = seed;
  return parse_scene(scene, fmt::format("{}: case {}: scene", study.where, c.name));
}

}  // namespace

ConvergenceStudy parse_convergence_study(const json& given, const std::string& where) {
  require_valid(outline(), given, where + ": study");
  text::require_plain_name(given["name"], where + ": name", "convergence");
  for (const json& c : given["cases"])
    text::require_plain_name(c["name"], where + ": the name of a case", "fast-15");
  ConvergenceStudy study;
  study.name = given["name"];
  study.document = given;
  study.where = where;
  study.schemes = given.value("schemes", std::vector{default_scheme()});
  const json by_scheme = given.value("by_scheme", json::object());
  for (const auto& [scheme, fields] : by_scheme.items()) {
    require_known(scheme, study.schemes, where);
    study.by_scheme[scheme] = sweeps::with_integers(fields);
  }
  for (const json& c : given["cases"])
    study.cases.push_back(parse_case(c, given.value("scene", json::object())));
  study.published_at_s = given_as<double>(given, "published_at_s");
  require_distinct(study.cases, where);
  for (const json& r : given["ladder"]) {
    ConvergenceStudy::Rung rung{r["particles_per_target"], r["seeds"],
                                r.value("cases", std::vector<std::string>{})};
    require_known(rung, study.cases, where);
    study.ladder.push_back(std::move(rung));
  }
  // Every scene is checked before anything runs.
  for (const ConvergenceStudy::Case& c : study.cases)
    for (const std::string& scheme : study.schemes)
      scene_of(study, c, scheme, study.ladder.front().particles_per_target, 1);
  return study;
}

ConvergenceStudy load_convergence_study(const std::filesystem::path& path) {
  const json document = text::load_given_json(path);
  sweeps::require_kind(sweeps::DocumentKind::convergence_study, document, text::given_name(path));
  return parse_convergence_study(document, text::given_name(path));
}

std::vector<ConvergenceRun> runs_of(const ConvergenceStudy& study) {
  std::vector<ConvergenceRun> runs;
  std::set<std::tuple<std::string, std::string, std::int64_t, std::int64_t>> there;
  for (const ConvergenceStudy::Rung& rung : study.ladder)
    for (std::int64_t seed = 1; seed <= rung.seeds; ++seed)
      for (const ConvergenceStudy::Case& c : study.cases) {
        if (!rung.cases.empty() && std::ranges::find(rung.cases, c.name) == rung.cases.end())
          continue;
        for (const std::string& scheme : study.schemes)
          if (there.emplace(scheme, c.name, rung.particles_per_target, seed).second)
            runs.push_back({scheme, c.name, rung.particles_per_target, seed,
                            scene_of(study, c, scheme, rung.particles_per_target, seed)});
      }
  std::ranges::stable_sort(runs, {}, [](const ConvergenceRun& run) {
    return std::pow(static_cast<double>(run.particles_per_target), 4.0 / 3) *
           static_cast<double>(run.seed);
  });
  return runs;
}

}  // namespace eerie::studies
