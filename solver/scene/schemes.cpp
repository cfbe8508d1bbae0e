#include "solver/scene/schemes.hpp"

#include <algorithm>

#include "solver/scene/scene.hpp"
#include "solver/scene/validate.hpp"

namespace eerie {
using nlohmann::json;

std::string default_scheme() { return schema_at(scene_schema(), "numerics.scheme")->at("default"); }

json with_scheme(json document) {
  const json given = document.value("numerics", json::object());
  const auto scheme = std::ranges::find(schemes, given.value("scheme", default_scheme()),
                                        [](const Scheme& s) { return std::string(s.token); });
  json numerics = json::parse(scheme->numerics);
  numerics.update(given);
  document["numerics"] = std::move(numerics);
  return document;
}

}  // namespace eerie
