#include "solver/scene/schemes.hpp"

#include <algorithm>

#include "solver/scene/scene.hpp"
#include "solver/scene/validate.hpp"

namespace eerie {
using nlohmann::json;

namespace {

/// Of a scheme that there is, with those of its base.
json numerics_of_scheme(const std::string& token) {
  const Scheme& scheme =
      *std::ranges::find(schemes, token, [](const Scheme& s) { return std::string(s.token); });
  const std::string base = scheme.base;
  json numerics = base.empty() ? json::object() : numerics_of_scheme(base);
  numerics.update(json::parse(scheme.numerics));
  return numerics;
}

}  // namespace

std::string default_scheme() { return schema_at(scene_schema(), "numerics.scheme")->at("default"); }

json with_scheme(json document) {
  const json given = document.value("numerics", json::object());
  json numerics = numerics_of_scheme(given.value("scheme", default_scheme()));
  numerics.update(given);
  document["numerics"] = std::move(numerics);
  return document;
}

}  // namespace eerie
