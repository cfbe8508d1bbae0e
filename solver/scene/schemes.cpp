#include "solver/scene/schemes.hpp"

#include <map>

#include "solver/scene/scene.hpp"
#include "solver/scene/validate.hpp"

namespace eerie {
using nlohmann::json;

const json& numerics_of_scheme(const std::string& token) {
  static const std::map<std::string, json> all = [] {
    std::map<std::string, json> made;
    for (const Scheme& scheme : schemes) {  // a base stands before what stands on it
      json numerics = *scheme.base != 0 ? made.at(scheme.base) : json::object();
      numerics.update(json::parse(scheme.numerics));
      made.emplace(scheme.token, std::move(numerics));
    }
    return made;
  }();
  return all.at(token);
}

std::string default_scheme() { return schema_at(scene_schema(), "numerics.scheme")->at("default"); }

json with_scheme(json document) {
  const json given = document.value("numerics", json::object());
  json numerics = numerics_of_scheme(given.value("scheme", default_scheme()));
  numerics.update(given);
  document["numerics"] = std::move(numerics);
  return document;
}

}  // namespace eerie
